#!/usr/bin/env python3
"""The problem matcher finds file, line and reason in what the programs say of malformed files: messages_test.py PREFIX"""

import json
import re
import subprocess
import sys
import tempfile

from installed import environment, find, finish, run

PREFIX = sys.argv[1]
FILES = {"point.instance": ("flatdt-instance 1\ndimension 2\nmanifold torus\npoints 1\n1/0 0\n", 5),
         "name.instance": ("flatdt-instance 1\ndimension 2\nmanifold Torus\npoints 1\n0 0\n", 3),
         "torsion.instance": ("flatdt-instance 1\ndimension 2\ngenerators 3\n1 0 1 0 1 0\n1 0 0 0 1 1\n-1 0 0 0 -1 0\n"
                              "points 1\n0 0\n", 3)}


def main():
    [matcher] = json.loads(find(PREFIX, "problem_matcher.json").read_text())["problemMatcher"]
    [pattern] = matcher["pattern"]
    complaints = []
    with tempfile.TemporaryDirectory() as folder:
        run(["flatdt", "generate", "--manifold", "torus", "-o", "good.instance"], cwd=folder, env=environment(PREFIX))
        run(["flatdt", "triangulate", "good.instance", "-o", "good.triangulation"], cwd=folder, env=environment(PREFIX))
        for name, (text, line) in FILES.items():
            with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
                file.write(text)
            # As a stream of CGAL every one of them is malformed in its first line.
            for command, line in ((["flatdt", "triangulate", name], line), (["flatdt-check", name, "good.triangulation"], line),
                                  (["flatdt-check", "--from", "cgal-p2t2", name], 1)):
                done = subprocess.run(command, cwd=folder, env=environment(PREFIX), capture_output=True, text=True, check=False)
                found = [re.match(pattern["regexp"], said) for said in done.stderr.splitlines()]
                found = [(m[pattern["file"]], int(m[pattern["line"]])) for m in found if m and m[pattern["message"]]]
                if done.returncode != 2 or found != [(name, line)]:
                    complaints.append(f"{command}: exit {done.returncode}, {found}, not line {line}: {done.stderr}")
    finish(complaints)


main()
