#!/usr/bin/env python3
"""Sums up what llvm-cov exports: covered lines and branches of each side of the wall.

Usage: coverage.py EXPORT.json EXPORT.lcov [--uncovered]
"plain" counts every line and branch. "aim" leaves out lines and branches that only a defect of the program itself can
reach: those at ensure(...), InternalError and the cases after the last of an enumeration; that is what the aims are for.
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PARTS = {"checker": ("checker/src", "checker/include"), "ref": ("ref/src", "ref/include"),
         "checker/cli": ("checker/cli",), "ref/cli": ("ref/cli",)}
AIMS = {"checker": (99.0, 95.0), "ref": (95.0, 85.0)}
INTERNAL = re.compile(r"\bensure\(|InternalError|\bstd::unreachable|// unreachable:")


class Source:
    """One file: the count of every line that has code, and both counts of every branch."""

    def __init__(self, path):
        self.path = path
        self.text = path.read_text().splitlines()
        self.lines = {}
        self.branches = {}

    def internal(self, line):
        # An assertion and its message may stand on two lines.
        return any(INTERNAL.search(self.text[k - 1]) for k in (line, line - 1) if 0 < k <= len(self.text))


def read(json_file, lcov_file):
    sources = {}

    def source(name):
        path = pathlib.Path(name)
        if not path.is_relative_to(ROOT):
            return None
        return sources.setdefault(path.relative_to(ROOT).as_posix(), Source(path))

    current = None
    with open(lcov_file, encoding="utf-8") as lcov:
        for row in lcov:
            if row.startswith("SF:"):
                current = source(row[3:].strip())
            elif row.startswith("DA:") and current is not None:
                number, count = row[3:].strip().split(",")[:2]
                current.lines[int(number)] = max(int(count), current.lines.get(int(number), 0))
    with open(json_file, encoding="utf-8") as export:
        data = json.load(export)["data"][0]
    for entry in data["files"]:
        current = source(entry["filename"])
        for branch in entry["branches"] if current is not None else []:
            place = tuple(branch[:4])
            old = current.branches.get(place, (0, 0))
            # Instantiations of one template add up.
            current.branches[place] = (old[0] + branch[4], old[1] + branch[5])
    return sources


def share(covered, count):
    return f"{100 * covered / count:6.2f} % ({covered} of {count})" if count else "      - (none)"


def sums(sources, folders, leave_out_internal):
    lines = branches = lines_covered = branches_covered = 0
    for name, source in sources.items():
        if not name.startswith(tuple(folder + "/" for folder in folders)):
            continue
        for number, count in source.lines.items():
            if leave_out_internal and source.internal(number):
                continue
            lines += 1
            lines_covered += count > 0
        for place, counts in source.branches.items():
            if leave_out_internal and source.internal(place[0]):
                continue
            branches += 2
            branches_covered += sum(count > 0 for count in counts)
    return (lines_covered, lines), (branches_covered, branches)


def print_uncovered(sources):
    for name in sorted(sources):
        if not name.startswith(("checker/", "ref/")) or "/tests/" in name:
            continue
        source = sources[name]
        missed = {number: "never run" for number, count in source.lines.items() if count == 0}
        for place, counts in source.branches.items():
            if (counts[0] == 0) != (counts[1] == 0):
                missed.setdefault(place[0], "never " + ("true" if counts[0] == 0 else "false"))
        for number in sorted(missed):
            if not source.internal(number):
                print(f"{name}:{number}: {missed[number]}: {source.text[number - 1].strip()}")


def main():
    sources = read(sys.argv[1], sys.argv[2])
    failed = False
    print(f"{'':12} {'':6} {'lines':32} branches")
    for part, folders in PARTS.items():
        for label, leave_out in (("plain", False), ("aim", True)):
            lines, branches = sums(sources, folders, leave_out)
            print(f"{part:12} {label:6} {share(*lines):32} {share(*branches)}")
            if leave_out and part in AIMS:
                for (covered, count), aim in zip((lines, branches), AIMS[part]):
                    failed = failed or 100 * covered < aim * count
    if "--uncovered" in sys.argv[3:]:
        print_uncovered(sources)
    if failed:
        raise SystemExit("coverage: below the aims " + ", ".join(
            f"{part} {lines} % of lines, {branches} % of branches" for part, (lines, branches) in AIMS.items()))


if __name__ == "__main__":
    main()
