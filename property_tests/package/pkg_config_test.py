#!/usr/bin/env python3
"""pkg-config: a C program and links with all libraries; the shared library exports the C interface only.

pkg_config_test.py PREFIX C-PROGRAM
"""

import re
import shutil
import subprocess
import sys
import tempfile

from installed import COMPILER, INSTRUMENTATION, environment, find, finish, run, skip

PREFIX, PROGRAM = sys.argv[1:3]


def flags(*arguments):
    return run(["pkg-config", *arguments], env=environment(PREFIX)).split()


def main():
    if not shutil.which("pkg-config"):
        skip("no pkg-config")
    complaints = []
    library = find(PREFIX, "libflatdt_checker.so")
    with tempfile.TemporaryDirectory() as folder:
        program = folder + "/c_program"
        run([COMPILER, "-x", "c", "-std=c99", PROGRAM, "-x", "none", *flags("--cflags", "--libs", "flatdt-checker-c"), "-o", program,
             *INSTRUMENTATION])
        run([program], env=environment(PREFIX, LD_LIBRARY_PATH=str(library.parent)))
        for package in ("flatdt-checker", "flatdt-ref", "flatdt-testing"):
            if package == "flatdt-testing" and not list(library.parent.glob("pkgconfig/flatdt-testing.pc")):
                continue
            subprocess.run([COMPILER, "-x", "c++", "-", "-x", "none", *flags("--cflags", "--libs", package), "-o", folder + "/a",
                            *INSTRUMENTATION], input="int main() {}\n", text=True, check=True)
    if not re.fullmatch(r"\d+\.\d+\.\d+", flags("--modversion", "flatdt-ref")[0]):
        complaints.append("the version")

    symbols = [line.split() for line in run(["nm", "-D", "--defined-only", library]).splitlines()]
    functions = sorted(symbol[2].split("@")[0] for symbol in symbols if symbol[1] == "T")
    declared = sorted(set(re.findall(r"FLATDT_API\s[^;(]*?(flatdt_\w+)\(", find(PREFIX, "include/flatdt/checker/c.h").read_text())))
    if functions != declared:
        complaints.append(f"exported {functions}, declared {declared}")
    others = [symbol for symbol in symbols if symbol[1] not in "TA"]
    if others:
        complaints.append(f"also exported: {others}")
    needed = run(["readelf", "-d", library])
    if "SONAME" not in needed or "libflatdt_checker.so.1" not in needed:
        complaints.append("the soname")
    finish(complaints)


main()
