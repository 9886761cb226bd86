#!/usr/bin/env python3
"""The index of the seeds: corpora/seeds/index.tsv, one line for each: target, file, what it is, what the programs say
of it, where it comes from.

Usage: seed_index.py BUILD --write [ORIGINS.tsv]    makes it anew; what make_seeds.py did not make is from a campaign
       seed_index.py BUILD --check [TARGET...]      exit code 1 if a seed is missing in it, or the programs say another
                                                    thing now; default: every target
BUILD is a build without a fuzzing engine.
"""
import pathlib
import subprocess
import sys
import tempfile

SEEDS = pathlib.Path(__file__).resolve().parent.parent / "corpora" / "seeds"
INDEX = SEEDS / "index.tsv"
NOTHING = "flatdt-triangulation 1\nelements 0\ncells 0\n"


class Programs:
    def __init__(self, build):
        self.build = pathlib.Path(build).resolve()
        self.folder = tempfile.TemporaryDirectory()
        self.scratch = pathlib.Path(self.folder.name)
        (self.scratch / "nothing").write_text(NOTHING)

    def run(self, *command):
        return subprocess.run([str(part) for part in command], cwd=self.scratch, capture_output=True, check=False)

    def files(self, target, seed):
        """The files that a seed means, by extension."""
        for old in self.scratch.glob("seed.*"):
            old.unlink()
        done = self.run(self.build / "fuzz" / f"fuzz_{target}", "--print", seed, "seed")
        if done.returncode != 0:
            raise SystemExit(f"{seed} cannot be printed: {done.stderr.decode()}")
        return {path.suffix[1:]: path for path in self.scratch.glob("seed.*")}

    def verdict(self, instance, triangulation):
        """The verdict, and the conditions that fail."""
        done = self.run(self.build / "checker" / "flatdt-check", instance, triangulation)
        lines = done.stdout.decode().splitlines()
        failing = [line.split()[2] for line in lines if line.startswith("c condition") and line.split()[3] == "fails"]
        return (lines[-1][2:] if lines else f"exit {done.returncode}"), failing

    def says(self, target, files):
        nothing = self.scratch / "nothing"
        if target in ("parse_instance", "group", "triangulate", "predicates"):
            verdict, failing = self.verdict(files.get("instance") or files["txt"], nothing)
            refused = [name for name in failing if name.startswith("group.")]
            if verdict == "MALFORMED" and not refused:
                return "malformed"
            if target == "parse_instance":
                return "well formed"
            return f"{refused[0]} fails" if refused else "admissible"
        if target == "parse_triangulation":
            malformed = self.verdict(files["instance"], files["triangulation"])[0] == "MALFORMED"
            return "malformed" if malformed else "well formed"
        if target == "check":
            verdict, failing = self.verdict(files["instance"], files["triangulation"])
            return " ".join([verdict] + failing)
        if target == "import_crystal":
            path = files.get("cif") or files["pdb"]
            options = files["options"].read_text().split()
            code = self.run(self.build / "ref" / "flatdt", "import", path, "-o", "imported", *options).returncode
            return "imported" if code == 0 else f"refused, exit {code}"
        if target == "import_cgal":
            [(kind, path)] = files.items()
            done = self.run(self.build / "checker" / "flatdt-check", "--from", f"cgal-{kind}", path)
            return done.stdout.decode().splitlines()[-1][2:]
        return "documented exit code"


def description(target, files):
    if target == "command_line":
        return files["command"].read_text().strip()
    if target == "import_crystal":
        return f"{'CIF' if 'cif' in files else 'PDB or neither'}, {(files.get('cif') or files['pdb']).stat().st_size} bytes"
    if target == "parse_instance":
        return f"{files['txt'].stat().st_size} bytes"
    if target == "import_cgal":
        [(kind, path)] = files.items()
        return f"{kind}, {path.stat().st_size} bytes"
    words = files["instance"].read_text().split()
    value = {key: words[words.index(key) + 1] for key in ("dimension", "manifold", "points") if key in words}
    text = f"{value['dimension']}D, {value.get('manifold', 'generators')}, {value['points']} points"
    if "triangulation" in files:
        words = files["triangulation"].read_bytes().decode("latin-1").split()
        if "cells" in words[:-1]:
            text += f", {words[words.index('cells') + 1]} cells"
    return text


def printable(text):
    return "".join(c if " " <= c <= "~" else "?" for c in text)[:160]


def rows(programs, targets):
    for folder in sorted(path for path in SEEDS.iterdir() if path.is_dir()):
        if targets and folder.name not in targets:
            continue
        for seed in sorted(folder.iterdir()):
            files = programs.files(folder.name, seed)
            yield folder.name, seed.name, printable(description(folder.name, files)), programs.says(folder.name, files)


def read(path, columns):
    with open(path, encoding="ascii") as table:
        return {tuple(row[:2]): row for row in (line.rstrip("\n").split("\t") for line in table) if len(row) == columns}


def main():
    if len(sys.argv) < 3 or sys.argv[2] not in ("--write", "--check"):
        raise SystemExit(__doc__)
    programs = Programs(sys.argv[1])
    old = read(INDEX, 5) if INDEX.exists() else {}
    if sys.argv[2] == "--write":
        origins = read(sys.argv[3], 3) if len(sys.argv) > 3 else {}
        lines = ["target\tfile\twhat\texpected\torigin"]
        for row in rows(programs, []):
            known = old.get(row[:2], [None] * 5)[4]
            lines.append("\t".join(row + (origins.get(row[:2], [None] * 3)[2] or known or "campaign",)))
        INDEX.write_text("\n".join(lines) + "\n")
        return
    wrong = count = 0
    for row in rows(programs, sys.argv[3:]):
        count += 1
        expected = old.get(row[:2], ["", "", "", "nothing: it is not in the index"])[3]
        if expected != row[3]:
            wrong += 1
            print(f"corpora/seeds/{row[0]}/{row[1]}: expected {expected}; found {row[3]}")
    print(f"{count} seeds, {wrong} other than the index says")
    sys.exit(1 if wrong or count == 0 else 0)


if __name__ == "__main__":
    main()
