#!/usr/bin/env python3
"""Holds flatdt-check to corpora/: invalid_corpus_test.py FLATDT-CHECK CORPORA

With --self-test instead: the test must complain about every way of breaking a small corpus and a fake program.

For every pair of files: the verdict, the exit code and the status of every condition are those of the record; the text
and --json channels agree, the latter with three threads; the last line is the `s` line. Every condition that the program prints has a folder in
corpora/invalid with a file on which it fails, and every folder, file and record belongs to something. Standard library only.
Source: FORMAT.md, "Programs" and "What the conditions mean".
"""

import contextlib
import io
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

EXIT = {"VERIFIED": 0, "REFUTED": 1, "MALFORMED": 2, "UNKNOWN": 3}
STATUS = ("holds", "fails", "skipped")
TIME_LIMIT = 120


class Failure(Exception):
    pass


def demand(truth, what):
    if not truth:
        raise Failure(what)


def read_record(path):
    """verdict, exit code, {condition: status}, which file the message names (or None)."""
    verdict = code = error = None
    status = {}
    for line in open(path, encoding="ascii"):
        words = line.split("#")[0].split()
        if not words:
            continue
        demand(len(words) == 2, f"record line {line!r}")
        key, value = words
        if key == "verdict":
            verdict = value
        elif key == "exit":
            code = int(value)
        elif key == "error":
            error = value
        else:
            demand(value in STATUS and key not in status, f"record line {line!r}")
            status[key] = value
    demand(verdict in EXIT and code == EXIT[verdict], "verdict and exit code of the record")
    return verdict, code, status, error


def run(program, *arguments):
    """The completed process of a program; a function in its place stands for one (--self-test)."""
    if callable(program):
        return program(*arguments)
    return subprocess.run([program, *arguments], stdin=subprocess.DEVNULL, capture_output=True, timeout=TIME_LIMIT)


def read_text(output):
    """verdict and {condition: status} in the order printed."""
    lines = output.decode("ascii").split("\n")
    demand(lines.pop() == "", "the output does not end with a line break")
    demand(len(lines) > 0 and re.fullmatch(r"s [A-Z]+", lines[-1]), "the last line is no s line")
    status = {}
    for line in lines[:-1]:
        demand(line == "c" or line.startswith("c "), f"line {line!r}")
        words = line.split()
        if words[1:2] == ["condition"]:
            demand(len(words) >= 4 and words[3] in STATUS and words[2] not in status, f"line {line!r}")
            status[words[2]] = words[3]
            demand(words[3] != "fails" or len(words) > 4, f"{words[2]} fails without a witness")
    return lines[-1][2:], status


def all_strings(value):
    if isinstance(value, dict):
        return all(map(all_strings, value.values()))
    return all(map(all_strings, value)) if isinstance(value, list) else isinstance(value, str)


def check_file(program, stem):
    """Returns {condition: status} as printed."""
    verdict, code, expected, error = read_record(stem + ".expected")
    files = stem + ".instance", stem + ".triangulation"
    text = run(program, *files)
    demand(text.returncode in EXIT.values(), f"exit code {text.returncode}: {text.stderr[-300:]!r}")
    said, status = read_text(text.stdout)
    differences = [f"{c}: record {expected.get(c)}, program {status.get(c)}"
                   for c in [*expected, *(c for c in status if c not in expected)] if expected.get(c) != status.get(c)]
    if (said, text.returncode) != (verdict, code):
        differences.insert(0, f"record {verdict} ({code}), program {said} ({text.returncode})")
    demand(not differences, "; ".join(differences))
    demand(list(status) == list(expected), "the order of the conditions")
    if code == 2:
        message = text.stderr.decode("utf-8", "replace")
        demand(message.strip(), "no reason on standard error")
        if error:
            named = re.search(re.escape(f"{stem}.{error}") + r":([0-9]+): \S", message)
            with open(f"{stem}.{error}", "rb") as bad:
                lines = bad.read().count(b"\n") + 1
            demand(named and 1 <= int(named[1]) <= lines, f"no {error}:line: reason in {message!r}")

    # The file's one fault is then in the first thread's range, the last one's or that between, in all of which it counts.
    report = run(program, *files, "--json", "--jobs", "3")
    demand(report.returncode == code, f"--json exits {report.returncode}")
    object_ = json.loads(report.stdout.decode("ascii"))
    demand(object_["schema"] == "flatdt-check 1" and object_["verdict"] == verdict, "--json: schema or verdict")
    demand([(c["name"], c["status"]) for c in object_["conditions"]] == list(status.items()), "--json: conditions")
    demand(all_strings(object_), "--json: a value that is no string")
    return status


def stems(folder):
    """The pairs of a folder; a file without its two companions is a failure."""
    found = {}
    for name in sorted(os.listdir(folder)):
        stem, dot, kind = name.rpartition(".")
        demand(dot and kind in ("instance", "triangulation", "expected"), f"{folder}/{name} does not belong here")
        found.setdefault(stem, set()).add(kind)
    for stem, kinds in found.items():
        demand(len(kinds) == 3, f"{folder}/{stem}: only {', '.join(sorted(kinds))}")
    return [os.path.join(folder, stem) for stem in found]


def fake(broken):
    """A program that prints what the record beside the instance says, in either format; `broken` spoils it."""
    def program(instance, triangulation, *options):
        with open(instance.replace(".instance", ".expected"), encoding="ascii") as record:
            rows = [line.split() for line in record if line[0] != "#"]
        verdict, code = rows[0][1], int(rows[1][1])
        status = [(n, s) for n, s in rows[2:] if n != "error"]
        if broken == "status" and verdict == "REFUTED":
            status[4] = status[4][0], "skipped"
        if broken == "extra":
            status.append(("topology.taste", "holds"))
        if broken == "order":
            status.reverse()
        if broken == "fewer":
            status.pop()
        if broken == "code":
            code = 0
        if broken == "verdict" or (broken == "json" and "--json" in options):
            verdict = "VERIFIED"
        if "--json" in options:
            number = 1 if broken == "number" else "1"
            out = json.dumps({"schema": "flatdt-check 1", "verdict": verdict,
                              "conditions": [{"name": n, "status": s, "witness": {"cell": number}} for n, s in status]})
        else:
            witness = "" if broken == "witness" else "cell 1"
            out = "".join(f"c condition {n} {s} {witness}\n" for n, s in status) + f"s {verdict}\n"
            out += "c done\n" if broken == "last" else ""
        reason = triangulation + ":1: spoiled\n" if code == 2 and broken != "silent" else ""
        return subprocess.CompletedProcess([], code, out.encode(), reason.encode())
    return program


def self_test():
    conditions = """group.crystallographic group.torsion-free group.name subgroup.member vertices.complete cells.nondegenerate
        facets.paired facets.opposite volume.exact delaunay.empty simplices.injective skeleton.no-loop skeleton.no-2-cycle
        complex.intersection links.spheres topology.connected topology.euler topology.orientable topology.homology""".split()

    def build(root):
        for folder in ["valid", "invalid/malformed"] + ["invalid/" + c for c in conditions]:
            os.makedirs(os.path.join(root, folder))
            wrong = folder.split("/")[-1]
            verdict = {"valid": "VERIFIED", "malformed": "MALFORMED"}.get(wrong, "REFUTED")
            status = {c: "skipped" if wrong == "malformed" else "fails" if c == wrong else "holds" for c in conditions}
            record = [f"verdict {verdict}", f"exit {EXIT[verdict]}"] + [f"{c} {s}" for c, s in status.items()]
            if wrong == "malformed":
                record.append("error triangulation")
            for kind, text in (("instance", ""), ("triangulation", ""), ("expected", "\n".join(record) + "\n")):
                with open(os.path.join(root, folder, "one." + kind), "w") as out:
                    out.write(text)

    def edit(path, old, new):
        text = open(path).read()
        assert old in text
        open(path, "w").write(text.replace(old, new))

    euler = "invalid/topology.euler"
    spoils = {
        "nothing": lambda r: None,
        "record missing": lambda r: os.remove(f"{r}/{euler}/one.expected"),
        "instance missing": lambda r: os.remove(f"{r}/{euler}/one.instance"),
        "folder empty": lambda r: [os.remove(f"{r}/{euler}/one.{k}") for k in ("expected", "instance", "triangulation")],
        "folder missing": lambda r: shutil.rmtree(f"{r}/{euler}"),
        "valid missing": lambda r: shutil.rmtree(f"{r}/valid"),
        "malformed missing": lambda r: shutil.rmtree(f"{r}/invalid/malformed"),
        "folder of no condition": lambda r: shutil.copytree(f"{r}/{euler}", f"{r}/invalid/topology.taste"),
        "file of no kind": lambda r: open(f"{r}/{euler}/notes", "w").close(),
        "record short": lambda r: edit(f"{r}/{euler}/one.expected", "group.name holds\n", ""),
        "record long": lambda r: edit(f"{r}/{euler}/one.expected", "group.name", "group.size holds\ngroup.name"),
        "record doubled": lambda r: edit(f"{r}/{euler}/one.expected", "group.name holds", "group.name holds\ngroup.name holds"),
        "record contradicts itself": lambda r: edit(f"{r}/{euler}/one.expected", "exit 1", "exit 0"),
        "condition does not fail in its folder": lambda r: edit(f"{r}/{euler}/one.expected", "topology.euler fails", "topology.euler holds"),
        "valid fails": lambda r: edit(f"{r}/valid/one.expected", "topology.euler holds", "topology.euler fails"),
    }
    spoils |= {b: None for b in ("status", "extra", "order", "fewer", "code", "verdict", "json", "number", "witness", "last", "silent")}
    bad = 0
    for name, spoil in spoils.items():
        with tempfile.TemporaryDirectory() as root:
            build(root)
            if spoil:
                spoil(root)
            out = io.StringIO()
            with contextlib.redirect_stdout(out):
                code = judge(fake("" if spoil else name), root)
        if code != (name != "nothing") or "complaints" not in out.getvalue():
            bad += 1
            print(f"{name}: exit {code}\n{out.getvalue()[-500:]}")
    print(f"{len(spoils)} corpora, {bad} judged wrong")
    return 1 if bad else 0


def judge(program, corpora):
    """Prints the complaints about a program and a corpus; 1 if there are any, else 0."""
    invalid = os.path.join(corpora, "invalid")
    complaints, fails_in, printed, count = [], {}, None, 0
    folders = [os.path.join(corpora, "valid")] + [os.path.join(invalid, f) for f in sorted(os.listdir(invalid))]  # a loose file fails as a folder
    for folder in folders:
        name = os.path.basename(folder)
        try:
            demand(os.path.isdir(folder), f"{folder} is missing")
            files = stems(folder)
            demand(files, f"{folder} is empty")
        except Failure as failure:
            complaints.append(str(failure))
            continue
        for stem in files:
            count += 1
            try:
                status = check_file(program, stem)
                demand(printed in (None, list(status)), "not the conditions of the files before")
                printed = list(status)
                fails_in.setdefault(name, set()).update(c for c, s in status.items() if s == "fails")
                if name == "valid":
                    demand("fails" not in status.values() and read_record(stem + ".expected")[0] == "VERIFIED", "is not valid")
                elif name != "malformed":
                    demand(status.get(name) == "fails", f"{name} does not fail")
            except (Failure, subprocess.TimeoutExpired, ValueError, KeyError, TypeError) as failure:
                complaints.append(f"{os.path.relpath(stem, corpora)}: {type(failure).__name__}: {failure}")
    for condition in printed or []:
        if condition not in fails_in.get(condition, ()):
            complaints.append(f"no file in invalid/{condition} on which it fails")
    for name in fails_in:
        if name not in ("valid", "malformed") and name not in (printed or []):
            complaints.append(f"invalid/{name} is the folder of no condition")
    if printed is None or len(printed) != 19:
        complaints.append(f"FORMAT.md has 19 conditions, the program prints {len(printed or [])}")
    for needed in ("valid", "malformed"):
        if needed not in fails_in:
            complaints.append(f"nothing checked in {needed}")
    for complaint in complaints:
        print(complaint)
    print(f"{count} files, {len(complaints)} complaints")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(self_test() if sys.argv[1:] == ["--self-test"] else judge(*sys.argv[1:]))
