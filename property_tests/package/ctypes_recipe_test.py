#!/usr/bin/env python3
"""The recipe that calls the shared library by ctypes: ctypes_recipe_test.py PREFIX RECIPES"""

import os
import subprocess
import sys
import tempfile

from installed import COMPILER, SANITIZED, environment, find, finish, run, skip

PREFIX, RECIPES = sys.argv[1:3]


def settings():
    """A sanitized library needs the run-time library before anything else; Python leaks by design."""
    more = {"FLATDT_LIBRARY": str(find(PREFIX, "libflatdt_checker.so.1"))}
    if SANITIZED:
        runtime = run([COMPILER, "-print-file-name=libasan.so"]).strip()
        if not os.path.isabs(runtime):
            skip("this compiler has no shared run-time library of AddressSanitizer")
        # The library that throws exceptions too: Python is not linked to it, and the run-time looks for it at the start.
        thrower = run([COMPILER, "-print-file-name=libstdc++.so.6"]).strip()
        more |= {"LD_PRELOAD": f"{runtime}:{thrower}", "ASAN_OPTIONS": "detect_leaks=0"}
    return environment(PREFIX, **more)


def main():
    complaints = []
    recipe, where = [sys.executable, f"{RECIPES}/ctypes_recipe.py"], settings()
    output = run(recipe, env=where)
    wanted = "all cells: VERIFIED\nwithout the last: REFUTED {'volume-of-cells': '17/18', 'expected': '1'"
    if not output.startswith(wanted):
        complaints.append(f"the example says {output}")
    with tempfile.TemporaryDirectory() as folder:
        instance, triangulation = f"{folder}/k.instance", f"{folder}/k.triangulation"
        run(["flatdt", "generate", "--manifold", "G2", "--points", "3", "-o", instance], env=environment(PREFIX))
        run(["flatdt", "triangulate", instance, "-o", triangulation], env=environment(PREFIX))
        for files, code, text in (((instance, triangulation), 0, "VERIFIED"),
                                  ((triangulation, instance), 2, "MALFORMED instance:1: ")):
            done = subprocess.run([*recipe, *files], env=where, capture_output=True, text=True, check=False)
            if done.returncode != code or not done.stdout.startswith(text):
                complaints.append(f"{files}: exit {done.returncode}, {done.stdout}{done.stderr}")
    finish(complaints)


main()
