#!/usr/bin/env python3
"""The examples that --help shows are run, in the order in which they are shown: examples_test.py PREFIX"""

import re
import subprocess
import sys
import tempfile

from installed import SANITIZED, environment, finish, run

PREFIX = sys.argv[1]
CRYSTAL = """data_x
_cell_length_a 5
_cell_length_b 6
_cell_length_c 7
_cell_angle_alpha 90
_cell_angle_beta 90
_cell_angle_gamma 90
_symmetry_space_group_name_H-M 'P 21 21 21'
loop_
_atom_site_label
_atom_site_fract_x
_atom_site_fract_y
_atom_site_fract_z
C1 0.1 0.2 0.3
"""


def shown(*command):
    """The lines after "Example:" or "Examples:", continued ones in one piece."""
    lines, inside = [], False
    for line in run(command, env=environment(PREFIX)).splitlines():
        if re.match(r"Examples?:$", line):
            inside = True
        elif inside and line.startswith("    "):
            lines[-1] += "\n" + line
        elif inside and line.startswith("  "):
            lines.append(line.strip())
        else:
            inside = False
    return lines


def main():
    complaints, count = [], 0
    text = run(["flatdt", "--help"], env=environment(PREFIX))
    commands = re.findall(r"^  ([a-z]+) ", text.partition("Subcommands:")[2].partition("Example")[0], re.MULTILINE)
    if len(commands) < 6:
        complaints.append(f"the commands of flatdt: {commands}")
    has_import = "import" in commands and subprocess.run(
        ["flatdt", "import", "-"], input="", capture_output=True, text=True, env=environment(PREFIX), check=False
    ).stderr.find("without gemmi") < 0
    with tempfile.TemporaryDirectory() as folder:
        with open(f"{folder}/crystal.cif", "w", encoding="utf-8") as crystal:
            crystal.write(CRYSTAL)
        for command in [["flatdt"], *(["flatdt", name] for name in commands), ["flatdt-check"], ["flatdt-campaign"]]:
            lines = shown(*command, "--help")
            if not lines:
                complaints.append(f"{' '.join(command)} --help shows no example")
            for line in lines:
                if command[-1] == "import" and not has_import:
                    continue
                if command[-1] not in line:
                    complaints.append(f"an example of {command} without it: {line}")
                # Sanitizers reserve more address space than children have by default.
                spacious = line + " --address-limit 0" if SANITIZED and "flatdt-campaign" in line else line
                done = subprocess.run(["bash", "-o", "pipefail", "-c", spacious], cwd=folder, env=environment(PREFIX), check=False,
                                      capture_output=True, text=True)
                count += 1
                if done.returncode != 0:
                    complaints.append(f"{line}: exit {done.returncode}\n{done.stdout}{done.stderr}")
                if "--serve" in line and '"verdict":"VERIFIED"' not in done.stdout:
                    complaints.append(f"{line}: {done.stdout}")
    print(f"{count} examples")
    finish(complaints)


main()
