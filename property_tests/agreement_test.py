#!/usr/bin/env python3
"""flatdt against flatdt-check, on adversarial and small generated instances: agreement_test.py FLATDT FLATDT-CHECK CORPORA [--adversarial]

For every instance: flatdt triangulates it, with the same bytes by both engines, and flatdt-check says VERIFIED. For those
of corpora/adversarial also: the table in its README (delta^2, Delta^2, sheets, cells, reason) is what flatdt says. For
generated ones also: another order of insertion and the cover of Theorem 10 give the same bytes, and
--smallest-cover what flatdt-check says VERIFIED of, in fewer cells. Stops at the first instance that goes wrong and
says which one of how many it was. Standard library only; the same on every machine.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import tempfile
from fractions import Fraction as F

CPU_LIMIT = 30  # seconds of one program; the machine may be busy with other things
TIME_LIMIT = 900
MEMORY_LIMIT = 4 << 30
PLANAR = ["torus", "klein-bottle"]
SPATIAL = ["torocosm", "dicosm", "tricosm", "tetracosm", "hexacosm", "didicosm", "first-amphicosm", "second-amphicosm",
           "first-amphidicosm", "second-amphidicosm"]
FAMILIES = ["uniform", "grid", "on-axis", "cospherical", "near-cospherical", "clustered", "on-glide-plane",
            "nearly-duplicate", "far-from-cell", "skew-basis", "single-orbit", "lattice"]


class Failure(Exception):
    pass


def set_limits():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT, CPU_LIMIT))


class Programs:
    def __init__(self, flatdt, check, sanitized):
        self.flatdt, self.check, self.sanitized, self.running, self.stopped = flatdt, check, sanitized, set(), False

    def stop(self):
        """Ends what runs and starts no more: one instance has gone wrong already."""
        self.stopped = True
        for process in list(self.running):
            process.kill()

    def run(self, what, *command):
        process = subprocess.Popen([str(c) for c in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, preexec_fn=None if self.sanitized else set_limits)
        self.running.add(process)
        try:
            if self.stopped:
                process.kill()
            out, err = process.communicate(timeout=TIME_LIMIT)
        except subprocess.TimeoutExpired:
            process.kill()
            out, err = process.communicate()
        self.running.discard(process)
        if process.returncode in (-signal.SIGXCPU, -signal.SIGKILL):  # the soft limit, and all others
            raise Failure(f"{what}: time-out")
        if process.returncode != 0:
            lines = [line for line in out.splitlines() if " fails" in line or line.startswith("s ")]
            raise Failure(f"{what}: exit {process.returncode}: {' | '.join(lines + err.splitlines()[:3])[:300]}")
        return out

    def triangulate(self, instance, output, *options):
        what = " ".join(["triangulate", *(str(o) for o in options if not isinstance(o, pathlib.Path))])
        self.run(what, self.flatdt, "triangulate", "-q", instance, "-o", output, *options)
        return pathlib.Path(output).read_bytes()

    def prove(self, instance, triangulation):
        last = self.run("check", self.check, instance, triangulation).splitlines()[-1]
        if last != "s VERIFIED":
            raise Failure(f"exit 0 with {last!r}")


def adversarial_table(folder):
    """{file: {column: text}} from the table of the README."""
    table, header = {}, None
    for line in (folder / "README.md").read_text().splitlines():
        cells = [c.strip() for c in line.strip().strip("|").split("|")]
        if line.startswith("| file"):
            header = cells
        elif header and line.startswith("| `"):
            for name in re.findall(r"`([^`]+)`", cells[0]):
                table[name] = dict(zip(header, cells))
    return table


def reason_text(reason):
    if reason is None:
        return ""
    if reason["kind"] == "loop":
        return "loop " + reason["point"]
    if reason["kind"] == "2-cycle":
        return "2-cycle " + " ".join(reason["points"])
    return "not invariant"


def check_adversarial(programs, path, row, folder):
    out, summary = folder / "t.triangulation", folder / "t.json"
    written = programs.triangulate(path, out, "--engine", "covering", "--json-summary", summary)
    programs.prove(path, out)
    if programs.triangulate(path, out) != written:
        raise Failure("the engines give different triangulations")
    facts = json.loads(summary.read_text())
    switched = facts["switched_after_points"]
    place = f"cover, {facts['sheets']}" if facts["stayed_in_cover"] else "manifold, " + (
        f"switched after {switched} points" if switched else "not switched")
    said = {"delta^2": facts["delta_squared"], "Delta^2": facts["Delta_squared"], "expected": place,
            "cells": facts["cells"], "reason": reason_text(facts["stayed_in_cover"])}
    for column, value in said.items():
        if "rounded" not in row[column] and value != row[column]:
            raise Failure(f"{column}: the table says {row[column]!r}, flatdt {value!r}")


def generated():
    """(manifold, family, points, metric, seed), small ones first, then some that leave the cover on the way."""
    jobs = []
    for n, take in ((1, 2), (2, 4), (4, 4)):
        for m, manifold in enumerate(PLANAR + SPATIAL):
            for k in range(take if n < 4 or manifold in PLANAR else 2):
                family = FAMILIES[(5 * m + 7 * k + n) % len(FAMILIES)]
                jobs.append((manifold, family, n, "random" if (m + k + n) % 3 == 0 else "canonical", 97 * m + k))
    jobs += [(manifold, family, n, "canonical", 7) for manifold in PLANAR
             for family, n in (("grid", 25), ("uniform", 60), ("cospherical", 40), ("nearly-duplicate", 12))]
    return jobs + [("torocosm", "grid", 64, "canonical", 1)]


def leaves_the_cover():
    """A lattice of 128 points in a first amphicosm, a quarter of the cell apart: the condition of Corollary 9 is met before the
    last of them, and orientation-reversing elements glue cells from then on."""
    points = [(F(i, 4) + h / 8, F(j, 4) + h / 16, F(k, 8) + h / 32)
              for i in range(4) for j in range(4) for k in range(4) for h in (F(0), F(1))]
    return "\n".join(["flatdt-instance 1 dimension 3 manifold first-amphicosm metric 1 0 0 1 0 4", f"points {len(points)}",
                      *(" ".join(map(str, p)) for p in points)]) + "\n"


def check_leaving(programs, folder):
    instance, out, summary = folder / "l.instance", folder / "l.triangulation", folder / "l.json"
    instance.write_text(leaves_the_cover())
    written = programs.triangulate(instance, out, "--engine", "covering", "--json-summary", summary)
    programs.prove(instance, out)
    if programs.triangulate(instance, out) != written:
        raise Failure("the engines give different triangulations")
    switched = json.loads(summary.read_text())["switched_after_points"]
    if switched is None or int(switched) == 128:
        raise Failure(f"switched after {switched} points")


def check_generated(programs, job, folder):
    manifold, family, points, metric, seed = job
    instance, out, other = folder / "g.instance", folder / "g.triangulation", folder / "o.triangulation"
    programs.run("generate", programs.flatdt, "generate", "--manifold", manifold, "--family", family, "--points", points,
                 "--metric", metric, "--seed", seed, "-o", instance)
    written = programs.triangulate(instance, out)
    programs.prove(instance, out)
    if programs.triangulate(instance, other, "--engine", "covering") != written:
        raise Failure("the engines give different triangulations")
    if written != programs.triangulate(instance, other, "--smallest-cover") and points <= 60:
        programs.prove(instance, other)
        least, safe = (cell_count(p) for p in (other, out))
        if least >= safe:
            raise Failure(f"--smallest-cover writes {least} cells where {safe} are written without it")
    if points <= 60:
        for engine in ("without-covers", "covering"):
            if programs.triangulate(instance, other, "--engine", engine, "--order", 1 + seed) != written:
                raise Failure(f"{engine}: another order of insertion gives another triangulation")
    if manifold in PLANAR and points <= 12 and programs.triangulate(instance, other, "--sheets", "theorem10") != written:
        raise Failure("the cover of Theorem 10 gives another triangulation")


def cell_count(triangulation):
    """The number of cells, which for one instance is proportional to that of sheets."""
    return int(re.search(r"^cells (\d+)", triangulation.read_text(), re.MULTILINE).group(1))


def cases(programs, corpora, adversarial_only):
    """(name, function of a folder)."""
    folder = corpora / "adversarial"
    table = adversarial_table(folder)
    files = sorted(folder.glob("*.instance"))
    if set(table) != {f.stem for f in files}:
        sys.exit("FAILED the table in corpora/adversarial/README.md does not list the instances beside it")
    work = [(f"adversarial/{f.stem}", lambda d, f=f: check_adversarial(programs, f, table[f.stem], d)) for f in files]
    if not adversarial_only:
        work += [(" ".join(map(str, job)), lambda d, job=job: check_generated(programs, job, d)) for job in generated()]
        work.append(("a lattice in the first amphicosm", lambda d: check_leaving(programs, d)))
    return work


def attempt(run):
    with tempfile.TemporaryDirectory(prefix="flatdt-agreement-") as folder:
        try:
            run(pathlib.Path(folder))
        except (Failure, ValueError, KeyError) as failure:
            return f"{type(failure).__name__}: {failure}"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("flatdt")
    parser.add_argument("check")
    parser.add_argument("corpora", type=pathlib.Path)
    parser.add_argument("--adversarial", action="store_true", help="only corpora/adversarial")
    parser.add_argument("--sanitized", action="store_true", help="no limits of CPU time and memory")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    programs = Programs(options.flatdt, options.check, options.sanitized)
    work = cases(programs, options.corpora, options.adversarial)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        results = pool.map(attempt, [run for _, run in work])
        for number, ((name, _), complaint) in enumerate(zip(work, results), 1):
            if complaint:
                programs.stop()
                pool.shutdown(wait=True, cancel_futures=True)
                print(f"FAILED case {number} of {len(work)}: {name}: {complaint}")
                return 1
    print(f"{len(work)} instances, all VERIFIED")
    return 0


if __name__ == "__main__":
    sys.exit(main())
