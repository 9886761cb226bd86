#!/usr/bin/env python3
"""The recipes for C++ built by find_package(flatdt) against the installed tree, run, and run with a fault.

consumer_test.py PREFIX RECIPES FOLDER: the project is built in the folder, without optimisation.
"""

import os
import shutil
import subprocess
import sys
import tempfile

from installed import COMPILER, INSTRUMENTATION, environment, finish, run

PREFIX, RECIPES, FOLDER = sys.argv[1:4]
# The sanitizers' build makes each case some five times slower.
CASES = "seed=1 max_success=" + ("10" if INSTRUMENTATION else "40")


def main():
    shutil.rmtree(FOLDER, ignore_errors=True)
    run(["cmake", "-S", RECIPES, "-B", FOLDER, f"-DCMAKE_PREFIX_PATH={PREFIX}", f"-DCMAKE_CXX_COMPILER={COMPILER}",
         "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O0 -Wall -Wextra -Werror",
         "-DCMAKE_EXE_LINKER_FLAGS=" + " ".join(INSTRUMENTATION)])
    run(["cmake", "--build", FOLDER, "--parallel", str(os.cpu_count())])
    complaints = []
    for name, texts in {
            "googletest_recipe": ["volume.exact fails: volume-of-cells=", "facets.paired fails: cell=", "REFUTED",
                                  "IsDelaunayOnTheKleinBottle", "IsDelaunayInSpace", "2 FAILED TESTS"],
            "rapidcheck_recipe": ["Falsifiable after 1 tests", "volume.exact fails: volume-of-cells=", "flatdt-instance 1",
                                  "points 1"]}.items():
        program = os.path.join(FOLDER, name)
        run([program], env=environment(PREFIX, RC_PARAMS=CASES))
        broken = subprocess.run([program], env=environment(PREFIX, RC_PARAMS=CASES, LEAVE_OUT_A_CELL="1"), capture_output=True,
                                text=True, check=False)
        output = broken.stdout + broken.stderr
        if broken.returncode != 1:
            complaints.append(f"{name} with a fault: exit {broken.returncode}\n{output}")
        complaints += [f"{name} with a fault does not say '{text}':\n{output}" for text in texts if text not in output]

    # A component that is not there is refused with its name.
    with tempfile.TemporaryDirectory() as other:
        with open(f"{other}/CMakeLists.txt", "w", encoding="utf-8") as project:
            project.write("cmake_minimum_required(VERSION 3.20)\nproject(p NONE)\n"
                          "find_package(flatdt REQUIRED COMPONENTS checker nonsense)\n")
        refused = subprocess.run(["cmake", "-S", other, "-B", f"{other}/build", f"-DCMAKE_PREFIX_PATH={PREFIX}"], text=True,
                                 capture_output=True, check=False)
    if refused.returncode == 0 or "nonsense" not in refused.stderr:
        complaints.append(f"find_package of an unknown component: {refused}")
    finish(complaints)


main()
