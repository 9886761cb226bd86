#!/usr/bin/env python3
"""Every installed header compiles alone; the C header as C too: headers_test.py PREFIX SOURCE [--all]

Without --all: with the build's compiler, and only headers that no source file includes first, since for the others the build
has shown it. --all: every header, with each of g++ 12, clang 14 and clang 19 that is found.
"""

import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

from installed import COMPILER, finish

PREFIX, SOURCE = map(pathlib.Path, sys.argv[1:3])
ALL = "--all" in sys.argv
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"]


def compilers():
    """The build's own first; each program once, whatever it is called."""
    found = {}
    for name in (COMPILER, *(("g++-12", "g++", "clang++-14", "clang++-19") if ALL else ())):
        path = shutil.which(name)
        if path:
            found.setdefault(os.path.realpath(path), path)
    return list(found.values())


def shown_by_the_build():
    """Names of headers that are the first include of a source file of the libraries."""
    found = set()
    for folder in ("ref/src", "checker/bindings", "property_tests/generators"):
        for source in (SOURCE / folder).glob("*.cpp"):
            first = re.search(r'^#include ["<]([^">]*)', source.read_text(), re.MULTILINE)
            found.add(first.group(1) if first else "")
    return found


def compile_alone(compiler, header, language):
    name = header.relative_to(PREFIX / "include")
    # Twice: it must also guard itself.
    text = f"#include <{name}>\n#include <{name}>\nint main(void) {{ return 0; }}\n"
    command = [compiler, "-fsyntax-only", *WARNINGS, *language, f"-I{PREFIX}/include", "-"]
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    return f"{os.path.basename(compiler)}, {name}:\n{done.stdout}{done.stderr}" if done.returncode else None


def main():
    headers = sorted((PREFIX / "include" / "flatdt").rglob("*.h*"))
    count = len(headers)
    if not ALL:
        shown = shown_by_the_build()
        headers = [header for header in headers if header.suffix == ".h" or str(header.relative_to(PREFIX / "include")) not in shown]
    jobs = []
    for compiler in compilers():
        for header in headers:
            jobs.append((compiler, header, ["-x", "c++", "-std=c++20"]))
            if header.suffix == ".h":
                jobs.append((compiler, header, ["-x", "c", "-std=c99"]))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        complaints = [found for found in pool.map(lambda job: compile_alone(*job), jobs) if found]
    print(f"{count} headers, {len(headers)} compiled alone, compilers: {', '.join(compilers())}")
    if count < 40:
        complaints.append(f"only {count} headers below {PREFIX}")
    finish(complaints)


main()
