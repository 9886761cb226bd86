#!/usr/bin/env python3
"""The recipe for GitHub Actions: its commands are run, in a workspace as the job has it.

github_recipe_test.py PREFIX RECIPES BUILD. The build is not repeated: `cmake --build` does nothing, and `cmake --install`
installs the tree under test. `apt-get` only prints. Everything else is run as it stands.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

from installed import environment, finish, python_with, run

PREFIX, RECIPES, BUILD = sys.argv[1:4]
SHELL = """
cmake() {
    case $1 in
        --build) test -f "$2/CMakeCache.txt" ;;
        --install) test -f "$2/CMakeCache.txt" && command cmake --install "$BUILD" --prefix "$INSTALLED" >/dev/null ;;
        *) command cmake "$@" >/dev/null ;;
    esac
}
apt-get() { echo "apt-get $*"; }
"""


def read(recipe):
    """The file, by a parser of YAML."""
    convert = "import json, sys, yaml; print(json.dumps(yaml.load(sys.stdin, yaml.BaseLoader)))"
    return json.loads(run([python_with("yaml"), "-c", convert], input=recipe.read_text()))


def main():
    complaints = []
    recipes = pathlib.Path(RECIPES)
    workflow = read(recipes / "github_actions.yml")
    if not {"name", "on", "jobs"} <= set(workflow):
        complaints.append(f"the keys of the workflow: {list(workflow)}")
    [job] = workflow["jobs"].values()
    steps = job["steps"]
    commands = [step["run"] for step in steps if "run" in step]
    for step in steps:
        if ("run" in step) == ("uses" in step):
            complaints.append(f"a step must have one of run and uses: {step}")
    with tempfile.TemporaryDirectory() as folder:
        # What the second checkout makes: the repository, in which a folder build appears.
        os.mkdir(f"{folder}/flatdt")
        for entry in os.listdir(recipes.parent.parent):
            if entry not in ("build", ".git"):
                os.symlink(recipes.parent.parent / entry, f"{folder}/flatdt/{entry}")
        installed = f"{folder}/installed"
        where = environment(PREFIX, BUILD=BUILD, INSTALLED=installed, **job["env"])
        where["PATH"] = f"{installed}/bin:{where['PATH']}"

        def execute(command, **more):
            return subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", SHELL + command], cwd=folder,
                                  env=where | more, capture_output=True, text=True, check=False)

        for command in commands:
            done = execute(command)
            print(command, done.stdout, sep="\n")
            if done.returncode != 0:
                complaints.append(f"{command}: exit {done.returncode}\n{done.stdout}{done.stderr}")
        if done.stdout.count(": VERIFIED") != 8:
            complaints.append(f"the last step does not check eight instances: {done.stdout}")
        if not os.access(f"{installed}/bin/flatdt-check", os.X_OK):
            complaints.append("nothing was installed")
        # A program that is wrong, and one that fails, make the job fail with annotations.
        with open(f"{folder}/faulty", "w", encoding="utf-8") as program:
            program.write("#!/bin/sh\nflatdt triangulate --quiet - | sed '/^cells/{s/.*/cells 1/;n;q}'\n")
        os.chmod(f"{folder}/faulty", 0o755)
        for program, text in ((f"{folder}/faulty", "::error file=instances/torus-uniform.instance::volume.exact fails: "),
                              ("false", "::error file=instances/torus-uniform.instance::the program failed")):
            done = execute(commands[-1], MY_TRIANGULATION=program)
            if done.returncode != 1 or text not in done.stdout:
                complaints.append(f"{program}: exit {done.returncode}\n{done.stdout}{done.stderr}")
    finish(complaints)


main()
