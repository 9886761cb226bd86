#!/usr/bin/env python3
"""The recipe of a fuzz target, by the command that stands in it: runs, and finds a fault.

fuzz_recipe_test.py PREFIX RECIPES
"""

import re
import shutil
import subprocess
import sys
import tempfile

from installed import INSTRUMENTATION, environment, finish, run, skip

PREFIX, RECIPES = sys.argv[1:3]


def compiler():
    """A clang++ with libFuzzer."""
    for name in ("clang++-19", "clang++-14", "clang++"):
        if not shutil.which(name):
            continue
        done = subprocess.run([name, "-fsanitize=fuzzer", "-x", "c++", "-", "-o", "/dev/null"], text=True, capture_output=True,
                              input='extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }',
                              check=False)
        if done.returncode == 0:
            return name
    return skip("no clang++ with libFuzzer (scripts/install-packages fuzz)")


def main():
    clang = compiler()
    with open(f"{RECIPES}/fuzz_recipe.cpp", encoding="utf-8") as recipe:
        lines = re.findall(r"^///   (.*)$", recipe.read(), re.MULTILINE)
    command = "\n".join(lines)
    build, _, _ = command.partition("&& ./fuzz_recipe")
    if not build.startswith("clang++ ") or "-runs=" not in command:
        sys.exit(f"the command in fuzz_recipe.cpp: {command}")
    build = build.replace("clang++", clang, 1).replace(" -O1", " -O0")
    if INSTRUMENTATION:  # the libraries have that of g++, whose run-time library this is not
        build = build.replace("-fsanitize=fuzzer,address", "-fsanitize=fuzzer,address,undefined")
    complaints = []
    with tempfile.TemporaryDirectory() as folder:
        for name in ("fuzz_recipe.cpp", "my_triangulation.cpp", "my_triangulation.hpp"):
            shutil.copy(f"{RECIPES}/{name}", folder)
        run(["sh", "-c", build], cwd=folder, env=environment(PREFIX))
        program = [folder + "/fuzz_recipe", "-runs=100", "-seed=1"]
        run(program, cwd=folder)
        broken = subprocess.run(program, cwd=folder, env=environment(PREFIX, LEAVE_OUT_A_CELL="1"), capture_output=True,
                                text=True, check=False)
        if broken.returncode == 0 or "REFUTED" not in broken.stderr or "--- triangulation" not in broken.stderr:
            complaints.append(f"with a fault: {broken}")
    finish(complaints)


main()
