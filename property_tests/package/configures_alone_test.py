#!/usr/bin/env python3
"""Each side configures alone, and its build installs its own component and nothing of the other: SOURCE"""

import pathlib
import sys
import tempfile

from installed import COMPILER, finish, run

SOURCE = pathlib.Path(sys.argv[1])


def main():
    complaints = []
    for side, other in (("checker", "ref"), ("ref", "checker")):
        with tempfile.TemporaryDirectory() as folder:
            run(["cmake", "-S", SOURCE / side, "-B", folder, f"-DCMAKE_CXX_COMPILER={COMPILER}"])
            script = (pathlib.Path(folder) / "cmake_install.cmake").read_text()
            if f'STREQUAL "{side}"' not in script or f'STREQUAL "{other}"' in script:
                complaints.append(f"{side} alone: the components of its installation")
            for name in (f"flatdt-{side}-targets.cmake", "flatdt-config.cmake", f"flatdt-{side}.pc"):
                if name not in script:
                    complaints.append(f"{side} alone does not install {name}")
    finish(complaints)


main()
