"""The main job: triangulate instances with flatdt, prove each result with flatdt-check, print a table.

Exit code 0 only if every instance is VERIFIED.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
MANIFOLDS = [
    "torus", "klein-bottle", "torocosm", "dicosm", "tricosm", "tetracosm", "hexacosm", "didicosm",
    "first-amphicosm", "second-amphicosm", "first-amphidicosm", "second-amphidicosm",
]
PLANAR = MANIFOLDS[:2]
# Six families of the matrix; the others join in where they are cheap.
FAMILIES = ["uniform", "grid", "on-axis", "cospherical", "near-cospherical", "clustered"]
MORE_FAMILIES = ["lattice", "on-glide-plane", "nearly-duplicate", "far-from-cell", "skew-basis", "single-orbit",
                 "moment-curve"]


class Job:
    def __init__(self, manifold, family, points, metric, seed, instance=None):
        self.manifold, self.family, self.points = manifold, family, points
        self.metric, self.seed, self.instance = metric, seed, instance

    def label(self):
        return self.family if self.metric in (None, "canonical") else f"{self.family} ({self.metric} metric)"


def default_jobs():
    """Up to 30 points: every family and size on every manifold in turn, both kinds of metric."""
    jobs = []
    for m, manifold in enumerate(MANIFOLDS):
        families = FAMILIES + MORE_FAMILIES
        for k, points in enumerate([1, 2, 3, 5, 10, 30]):
            take = 6 if manifold in PLANAR else 3 if points <= 10 else 2
            for i in range(take):
                family = families[(m + 5 * k + i) % len(families)]
                metric = "random" if (i + k) % 3 == 2 and points <= 10 else "canonical"
                jobs.append(Job(manifold, family, points, metric, 1000 * m + 10 * k + i))
    return jobs + crystal_jobs(100)


def quick_jobs():
    jobs = []
    for m, manifold in enumerate(MANIFOLDS):
        for k, points in enumerate([1, 2, 3, 5]):
            families = FAMILIES + MORE_FAMILIES
            jobs.append(Job(manifold, families[(m + 3 * k) % len(families)], points,
                            "random" if (m + k) % 4 == 0 else "canonical", 100 * m + k))
    return jobs + crystal_jobs(20)


def full_jobs():
    """The matrix: all sizes of six families at canonical and random metrics, the other families, the large ones."""
    jobs = []
    for m, manifold in enumerate(MANIFOLDS):
        for points in [1, 2, 3, 5, 10, 30, 100]:
            for f, family in enumerate(FAMILIES):
                for metric in ["canonical", "random"]:
                    jobs.append(Job(manifold, family, points, metric, 100 * m + 10 * f + points))
            for f, family in enumerate(MORE_FAMILIES):
                jobs.append(Job(manifold, family, points, "canonical", 100 * m + 10 * f + points + 7))
        large = 10000 if manifold in ("torus", "torocosm") else 1000
        jobs.append(Job(manifold, "uniform", large, "canonical", m))
    return jobs + crystal_jobs(None)


def crystal_jobs(most_sites):
    jobs = []
    for path in sorted((ROOT / "corpora" / "crystals").glob("*.instance")):
        found = re.search(r"^points\s+(\d+)", path.read_text(), re.MULTILINE)
        points = int(found.group(1))
        if most_sites is None or points <= most_sites:
            jobs.append(Job(None, "crystal " + path.stem, points, None, None, instance=path))
    return jobs


def run(job, programs, keep):
    """Returns a row: manifold, points, sheets, cells, verdict, seconds."""
    begin = time.monotonic()
    row = {"manifold": job.manifold or "?", "family": job.label(), "points": job.points, "sheets": "-", "cells": "-",
           "verdict": "FAILED", "detail": ""}
    with tempfile.TemporaryDirectory(prefix="flatdt-verify-") as folder:
        folder = pathlib.Path(keep or folder)
        stem = "-".join(str(x) for x in (row["manifold"], job.family, job.points, job.metric)).replace(" ", "-")
        stem = stem.replace("?", "crystal")
        instance = job.instance or folder / (stem + ".instance")
        triangulation, summary = folder / (stem + ".triangulation"), folder / (stem + ".json")
        steps = []
        if job.instance is None:
            steps.append([programs / "ref" / "flatdt", "generate", "--manifold", job.manifold, "--points",
                          str(job.points), "--family", job.family, "--seed", str(job.seed), "--metric", job.metric,
                          "-o", instance])
        steps.append([programs / "ref" / "flatdt", "triangulate", "--quiet", instance, "-o", triangulation,
                      "--json-summary", summary])
        for step in steps:
            done = subprocess.run([str(s) for s in step], capture_output=True, text=True)
            if done.returncode != 0:
                row["detail"] = f"exit {done.returncode}: {done.stderr.strip()}"
                row["seconds"] = time.monotonic() - begin
                return row
        facts = json.loads(summary.read_text())
        row.update(manifold=facts["manifold"], sheets=facts["sheets"], cells=facts["cells"])
        done = subprocess.run([str(programs / "checker" / "flatdt-check"), str(instance), str(triangulation)],
                              capture_output=True, text=True)
        lines = done.stdout.splitlines()
        verdict = lines[-1][2:] if lines and lines[-1].startswith("s ") else "no verdict"
        row["verdict"] = verdict
        # Two channels, one verdict.
        if (verdict == "VERIFIED") != (done.returncode == 0):
            row["verdict"] = f"{verdict} with exit {done.returncode}"
        if row["verdict"] != "VERIFIED":
            row["detail"] = "; ".join([l for l in lines if " fails" in l] + [done.stderr.strip()])
    row["seconds"] = time.monotonic() - begin
    return row


def progress(done, total, failures, begin):
    if not sys.stderr.isatty():
        return
    elapsed = time.monotonic() - begin
    eta = elapsed / done * (total - done) if done else 0
    width = 30
    bar = "#" * (width * done // total)
    print(f"\r[{bar:<{width}}] {done}/{total}  failures {failures}  ETA {eta:4.0f} s ", end="", file=sys.stderr,
          flush=True)


def run_peers(programs):
    """Other programs' opinions: Regina on the manifolds, GAP on the catalogue's groups. What is not installed is skipped
    with a message. Returns the exit code."""
    folder = ROOT / "property_tests" / "peers"
    flatdt = str(programs / "ref" / "flatdt")
    code = 0
    for command in (["manifolds_by_regina.py", flatdt, "--valid", str(ROOT / "corpora" / "valid")],
                    ["groups_by_gap.py", flatdt]):
        sys.stdout.flush()
        done = subprocess.run([sys.executable, str(folder / command[0]), *command[1:]])
        if done.returncode not in (0, 77):
            code = 1
    return code


def main():
    parser = argparse.ArgumentParser(
        prog="scripts/verify", description="Triangulate on every manifold and prove every result.")
    size = parser.add_mutually_exclusive_group()
    size.add_argument("--quick", action="store_true", help="up to 5 points, the smallest crystals")
    size.add_argument("--full", action="store_true",
                      help="the matrix: 1..100 points of all families, both kinds of metrics, 1,000 and 10,000 points, all crystals")
    parser.add_argument("--crystals", action="store_true", help="only the crystals, all of them")
    parser.add_argument("--peers", action="store_true",
                        help="instead: Regina recognises the manifolds, GAP confirms the groups, where installed")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="instances at a time")
    parser.add_argument("--keep", help="keep the files in this folder")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build" / "release", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.peers:
        return run_peers(options.programs.resolve())
    if options.keep:
        pathlib.Path(options.keep).mkdir(parents=True, exist_ok=True)
    jobs = crystal_jobs(None) if options.crystals else quick_jobs() if options.quick else full_jobs(
    ) if options.full else default_jobs()
    if not jobs:
        print("verify: no instances", file=sys.stderr)
        return 1

    begin = time.monotonic()
    header = f"{'manifold':<19} {'points of':<34} {'points':>6} {'sheets':>6} {'cells':>8} {'verdict':<10} {'seconds':>8}"
    print(header)
    failures = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        # The dearest first, so that none runs alone at the end; rows are printed in the jobs' order.
        order = sorted(range(len(jobs)), key=lambda i: -jobs[i].points)
        futures = {i: pool.submit(run, jobs[i], options.programs, options.keep) for i in order}
        pending = set(futures.values())
        printed = 0
        while printed < len(jobs):
            finished, pending = concurrent.futures.wait(pending, return_when=concurrent.futures.FIRST_COMPLETED)
            progress(len(jobs) - len(pending), len(jobs), failures, begin)
            while printed < len(jobs) and futures[printed].done():
                row = futures[printed].result()
                if sys.stderr.isatty():
                    print("\r\033[K", end="", file=sys.stderr, flush=True)
                print(f"{row['manifold']:<19} {row['family']:<34} {row['points']:>6} {row['sheets']:>6} "
                      f"{row['cells']:>8} {row['verdict']:<10} {row['seconds']:>8.2f}", flush=True)
                if row["verdict"] != "VERIFIED":
                    failures += 1
                    print(f"    {row['detail']}", flush=True)
                printed += 1
    if sys.stderr.isatty():
        print("\r\033[K", end="", file=sys.stderr, flush=True)
    verified = len(jobs) - failures
    print(f"{verified} of {len(jobs)} VERIFIED in {time.monotonic() - begin:.0f} s")
    return 0 if failures == 0 else 1


if __name__ == "__main__":
    sys.exit(main())
