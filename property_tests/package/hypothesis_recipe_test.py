#!/usr/bin/env python3
"""The recipe for Hypothesis: passes with the reference, and shrinks and explains a fault.

hypothesis_recipe_test.py PREFIX RECIPES
"""

import os
import subprocess
import sys
import tempfile

from installed import SANITIZED, environment, finish, python_with

PREFIX, RECIPES = sys.argv[1:3]
# Leaves out all cells but the first where there are more than two points.
FAULTY = r"""#!/bin/sh
instance=$(cat)
case $instance in
    *"points 1"* | *"points 2"*) printf '%s\n' "$instance" | flatdt triangulate --quiet - ;;
    *) printf '%s\n' "$instance" | flatdt triangulate --quiet - | sed '/^cells/{s/.*/cells 1/;n;q}' ;;
esac
"""


def main():
    recipe = [python_with("hypothesis"), f"{RECIPES}/hypothesis_recipe.py"]
    examples = {"EXAMPLES": "10" if SANITIZED else "25", "PYTHONDONTWRITEBYTECODE": "1"}
    complaints = []
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(recipe, env=environment(PREFIX, **examples), capture_output=True, text=True, check=False, cwd=folder)
        if done.returncode != 0 or "all Delaunay" not in done.stdout:
            complaints.append(f"exit {done.returncode}: {done.stdout}{done.stderr}")
        faulty = os.path.join(folder, "faulty")
        with open(faulty, "w", encoding="utf-8") as program:
            program.write(FAULTY)
        os.chmod(faulty, 0o755)
        done = subprocess.run(recipe, env=environment(PREFIX, MY_TRIANGULATION=faulty, **examples), capture_output=True, text=True,
                              check=False, cwd=folder)
        # Shrunk to three points, all at the origin.
        for text in ("volume.exact fails: volume-of-cells=", "metric 1 0 1\npoints 3\n  0 0\n  0 0\n  0 0\n"):
            if done.returncode == 0 or text not in done.stderr:
                complaints.append(f"with a fault: exit {done.returncode}, no {text!r}: {done.stdout}{done.stderr}")
    finish(complaints)


main()
