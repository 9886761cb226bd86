#!/usr/bin/env python3
"""The installed flatdt-campaign finds the flatdt beside it, finds what is wrong, and takes the files that come with it:
campaign_test.py PREFIX
"""

import os
import pathlib
import subprocess
import sys
import tempfile

from installed import SANITIZED, environment, find, finish

PREFIX = sys.argv[1]
COMMON = ["--points", "1..3", "--family", "uniform", "--seed", "1"]
# A program that leaves out the last line of every triangulation.
FAULTY = "sh -c 'flatdt triangulate -q - | sed \\$d'"


def campaign(folder, *words):
    # Sanitizers reserve more address space than children have by default.
    spacious = ["--address-limit", "0"] if SANITIZED else []
    return subprocess.run(["flatdt-campaign", *COMMON, *spacious, *words], cwd=folder, env=environment(PREFIX),
                          capture_output=True, text=True, check=False)


def main():
    complaints = []

    def expect(holds, done, what):
        if not holds:
            complaints.append(f"{what}: exit {done.returncode}\n{done.stdout}{done.stderr}")

    with tempfile.TemporaryDirectory() as folder:
        done = campaign(folder, "--manifold", "torus", "--cases", "3", "--out", "own")
        expect(done.returncode == 0 and "3 cases: 3 right" in done.stdout, done, "flatdt itself")
        done = campaign(folder, "--against", FAULTY, "--manifold", "torus", "--cases", "1", "--out", "faulty")
        picture = list(pathlib.Path(folder).glob("faulty/findings/case-0/picture.*"))
        expect(done.returncode == 1 and "1 x malformed" in done.stdout and not picture, done, "a program that is wrong")
        for name in ("cgal_2.json", "cgal_3.json", "voro.json"):
            done = campaign(folder, "--capabilities", find(PREFIX, name), "--against", "true", "--cases", "0", "--out", name)
            expect(done.returncode == 0, done, name)
        pathlib.Path(folder, "wrong.json").write_text('{"schema": "flatdt-capabilities 1", "unsupported_exit": 0}', encoding="ascii")
        done = campaign(folder, "--capabilities", "wrong.json", "--cases", "1", "--out", "wrong")
        expect(done.returncode == 2 and 'wrong.json: "unsupported_exit" must be' in done.stderr, done, "a wrong file")
        # Adapters are installed where they were built.
        for name, data in (("flatdt-cgal-2", "cgal_2.json"), ("flatdt-cgal-3", "cgal_3.json"), ("flatdt-voro", "voro.json")):
            if not os.access(f"{PREFIX}/bin/{name}", os.X_OK):
                print(f"{name} was not built")
                continue
            done = campaign(folder, "--against", f"{name} --loop", "--persistent", "--capabilities", find(PREFIX, data),
                            "--cases", "2", "--out", name)
            expect(done.returncode == 0 and "2 right" in done.stdout, done, name)
    finish(complaints)


main()
