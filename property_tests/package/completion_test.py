#!/usr/bin/env python3
"""Completion in bash, and in zsh where it is installed: completion_test.py PREFIX"""

import os
import shutil
import subprocess
import sys
import tempfile

from installed import environment, find, finish

PREFIX = sys.argv[1]
# The words typed, the last unfinished; what must be offered, and what must not.
CASES = [
    (["flatdt", "tri"], ["triangulate"], ["info"]),
    (["flatdt", ""], ["manifolds", "info", "generate", "triangulate", "import", "draw"], ["--help"]),
    (["flatdt", "--v"], ["--version"], ["--help"]),
    (["flatdt", "triangulate", "--s"], ["--sheets", "--smallest-cover"], ["--seed"]),
    (["flatdt", "generate", "-"], ["-o", "--output", "--seed", "--help", "-h"], ["--sheets"]),
    (["flatdt", "generate", "--manifold", "d"], ["dicosm", "didicosm"], ["torus"]),
    (["flatdt", "generate", "--family", "co"], ["cospherical"], ["uniform", "list"]),
    (["flatdt", "triangulate", "--engine", "c"], ["covering"], ["without-covers"]),
    (["flatdt", "draw", "--format", ""], ["svg", "vtu", "html"], ["k.instance"]),
    (["flatdt", "info", "k"], ["k.instance"], ["other"]),
    (["flatdt-check", "--"], ["--json", "--serve", "--max-bytes", "--help"], ["-h"]),
    (["flatdt-check", "k"], ["k.instance"], ["other"]),
    (["flatdt-campaign", "--m"], ["--manifold", "--memory-limit", "--minimise-runs"], ["--seed", "-h"]),
    (["flatdt-campaign", "--manifold", "d"], ["dicosm", "didicosm"], ["torus"]),
    (["flatdt-campaign", "--family", "th"], ["thin-band"], ["uniform", "list"]),
    (["flatdt-campaign", "--claims", ""], ["triangulation", "edges"], ["k.instance"]),
    (["flatdt-campaign", "--capabilities", "k"], ["k.instance"], ["other"]),
]
BASH = """
source "$1"; shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
function=$(complete -p "$1" | sed 's/.*-F \\([^ ]*\\).*/\\1/')
$function "$1" "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD - 1]}"
printf '%s\\n' "${COMPREPLY[@]}"
"""
# zsh's own functions are stood in for: what would be offered is printed.
ZSH = """
file=$1; shift
words=("$@") CURRENT=$#
compadd() { shift; for word in "$@"; do [[ $word == $words[CURRENT]* ]] && print -r -- $word; done }
_files() { print -l -- $words[CURRENT]*(N) }
source $file
"""


def main():
    complaints = []
    with tempfile.TemporaryDirectory() as folder:
        for name in ("k.instance", "other"):
            with open(os.path.join(folder, name), "w", encoding="utf-8"):
                pass
        for shell, script, pattern in (("bash", ["bash", "--norc", "-c", BASH, "bash"], "bash-completion/completions/{}"),
                                       ("zsh", ["zsh", "-f", "-c", ZSH, "zsh"], "site-functions/_{}")):
            if not shutil.which(shell):
                print(f"{shell} is not installed: its completion is not tested")
                continue
            for words, offered, not_offered in CASES:
                file = find(PREFIX, pattern.format(words[0]))
                done = subprocess.run([*script, str(file), *words], cwd=folder, env=environment(PREFIX), capture_output=True,
                                      text=True, check=False)
                found = done.stdout.split()
                wrong = [word for word in offered if word not in found] + [word for word in not_offered if word in found]
                if wrong or done.stderr:
                    complaints.append(f"{shell}, {words}: {found}, wrong in {wrong}; {done.stderr}")
    finish(complaints)


main()
