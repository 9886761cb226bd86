"""What the tests of the installed package share: where things are, and how they are run."""

import glob
import os
import pathlib
import shutil
import subprocess
import sys

SKIPPED = 77
INSTRUMENTATION = os.environ.get("FLATDT_INSTRUMENTATION", "").split()
SANITIZED = any("-fsanitize" in flag for flag in INSTRUMENTATION)
COMPILER = os.environ.get("FLATDT_CXX", "c++")


def skip(reason):
    print("skipped:", reason)
    sys.exit(SKIPPED)


def find(prefix, pattern):
    """The one file below the prefix that matches."""
    found = glob.glob(str(pathlib.Path(prefix) / "**" / pattern), recursive=True)
    if len(found) != 1:
        sys.exit(f"{pattern}: found {found} below {prefix}")
    return pathlib.Path(found[0])


def environment(prefix, **more):
    """With the package's programs first in PATH, and its files where pkg-config looks."""
    folder = find(prefix, "flatdt-checker.pc").parent
    return os.environ | {"PATH": f"{prefix}/bin:{os.environ['PATH']}", "PKG_CONFIG_PATH": str(folder)} | more


def run(command, **options):
    """The output of a command that must succeed."""
    options = {"capture_output": True, "text": True, "timeout": 500, "check": False} | options
    done = subprocess.run([str(word) for word in command], **options)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: exit {done.returncode}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def python_with(module):
    """An interpreter that has the module: this one or the system's; else the test is skipped."""
    for program in (sys.executable, "/usr/bin/python3"):
        if shutil.which(program) and subprocess.run([program, "-c", f"import {module}"], capture_output=True,
                                                    check=False).returncode == 0:
            return program
    return skip(f"no Python with the module {module} (scripts/install-packages test)")


def finish(complaints):
    for complaint in complaints:
        print("FAILED:", complaint)
    print("all passed" if not complaints else f"{len(complaints)} complaints")
    sys.exit(bool(complaints))
