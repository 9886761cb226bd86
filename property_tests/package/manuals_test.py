#!/usr/bin/env python3
"""The manual pages: well formed for man and mandoc, and they name every option and command of --help and no other.

manuals_test.py PREFIX
"""

import re
import shutil
import subprocess
import sys

from installed import environment, find, finish, run

PREFIX = sys.argv[1]


def lint(page):
    for command in (["man", "--warnings", "-l", page], ["mandoc", "-T", "lint", "-W", "warning", page]):
        if not shutil.which(command[0]):
            print(f"{command[0]} is not installed: {page.name} is not tested with it")
            continue
        done = subprocess.run(command, capture_output=True, text=True, check=False, env=environment(PREFIX, LC_ALL="C.UTF-8"))
        found = done.stderr + (done.stdout if command[0] == "mandoc" else "")
        # A machine without manual pages has a man that says so, and nothing else, whatever it is asked.
        if "minimized" in done.stdout + done.stderr:
            continue
        if done.returncode != 0 or found:
            yield f"{' '.join(map(str, command))}: {found}"


def options_of(text):
    """The options of a help text, at the start of their lines."""
    found = set()
    for names in re.findall(r"^  (-[^ ]+)", text.partition("Options:")[2], re.MULTILINE):
        found.update(names.split(","))
    return found


def main():
    complaints = []
    for program in ("flatdt", "flatdt-check", "flatdt-campaign"):
        page = find(PREFIX, f"{program}.1")
        complaints += lint(page)
        text = page.read_text().replace("\\-", "-")
        help_text = run([program, "--help"], env=environment(PREFIX))
        options = options_of(help_text)
        for command in re.findall(r"^  ([a-z]+) ", help_text.partition("Subcommands:")[2].partition("Example")[0], re.MULTILINE):
            options |= options_of(run([program, command, "--help"], env=environment(PREFIX)))
            if f".SS {command}\n" not in text:
                complaints.append(f"{page.name} lacks the command {command}")
        if len(options) < 5:
            complaints.append(f"only {options} in the help of {program}")
        named = set(re.findall(r"(?<![\w-])--?[a-z][a-z-]*", " ".join(re.findall(r"^\.TP\n(.*)$", text, re.MULTILINE))))
        for option in sorted(options - named):
            complaints.append(f"{page.name} does not explain {option}")
        for option in sorted(named - options):
            complaints.append(f"{page.name} explains {option}, which {program} does not have")
    finish(complaints)


main()
