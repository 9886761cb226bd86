"""Seeded faults: every patch below ref/ and checker/ here is one plausible bug, and some test must notice it.

Each is applied to a copy of the tree and built there; the detectors run until one fails: first the one that the patch
names, then the others from cheap to costly. Exit 0 only if every fault is killed. A fault that does not apply or compile is an error, not a kill; so is one whose killer fails without it as well.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import sys
import time

sys.dont_write_bytecode = True

import detectors  # noqa: E402
import workspace  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
KINDS = ("ref", "checker")
MEMORY_LIMIT = 6 << 30  # bytes, of one process


def all_faults():
    return [(kind, path) for kind in KINDS for path in sorted((HERE / kind).glob("*.patch"))]


def selected(names):
    """Faults by kind, by name or by kind/name."""
    chosen = [f for f in all_faults() if not names or f[0] in names or f[1].stem in names or f"{f[0]}/{f[1].stem}" in names]
    known = {x for kind, path in all_faults() for x in (kind, path.stem, f"{kind}/{path.stem}")}
    unknown = [n for n in names if n not in known]
    if unknown:
        sys.exit("faults: there is no fault called " + ", ".join(unknown))
    return chosen


def rotated(faults, share):
    """`K/N`: every N-th fault from the K-th on; `N`: K follows from the commit, so that each commit takes others."""
    part, _, parts = share.rpartition("/")
    parts = max(1, int(parts))
    if not part:
        commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=ROOT, capture_output=True, text=True).stdout.strip()
        part = int(commit[:8] or "0", 16)
    print(f"rotating: part {int(part) % parts} of {parts}")
    return faults[int(part) % parts::parts]


def header(patch, key):
    """The text after `key:` in the lines above the patch, or ""."""
    lines = iter(patch.read_text().split("\ndiff --git ")[0].splitlines())
    text = next((line[len(key) + 1:].strip() for line in lines if line.startswith(key + ":")), "")
    for line in lines:
        if not text or not line.startswith("  "):
            break
        text += " " + line.strip()
    return text


def misfits(faults):
    """The faults that no longer apply to this tree, or do not say what they are."""
    environment = os.environ | {"GIT_CEILING_DIRECTORIES": str(ROOT.parent)}
    bad = []
    for kind, path in faults:
        done = subprocess.run(["git", "apply", "--check", path], cwd=ROOT, env=environment, capture_output=True, text=True)
        if done.returncode != 0:
            bad.append(f"{kind}/{path.stem}: {done.stderr.strip()}")
        keys = ["Bug", "Plausible", "Source", "Detector" if kind == "ref" else "Condition"]
        bad += [f"{kind}/{path.stem}: no line {key}:" for key in keys if not header(path, key)]
        if kind == "ref" and header(path, "Detector") not in {d.name for d in detectors.DETECTORS[kind]}:
            bad.append(f"{kind}/{path.stem}: there is no such detector")
    weakened = {header(path, "Condition") for kind, path in all_faults() if kind == "checker"}
    folders = {folder.name for folder in (ROOT / "corpora" / "invalid").iterdir()}
    bad += [f"no fault weakens {name}" for name in sorted(folders - weakened)]
    return bad + [f"there is no folder corpora/invalid/{name}" for name in sorted(weakened - folders)]


class Run:
    """The faults of one kind, in a workspace of their own."""

    def __init__(self, kind, space):
        self.space, self.sound, self.detectors = space, set(), []
        space.prepare(lambda existing: self.choose(detectors.DETECTORS[kind], existing))

    def choose(self, table, existing):
        """The targets of the detectors that this tree has."""
        self.detectors = [d for d in table if existing.issuperset(d.targets)]
        missing = [d.name for d in table if d not in self.detectors and not d.optional]
        if missing:
            sys.exit("faults: this tree does not build " + ", ".join(missing))
        return sorted({target for d in self.detectors if not d.lazy for target in d.targets})

    def kill(self, patch):
        """The detector and its finding, or None if all pass."""
        expected, condition = header(patch, "Detector"), header(patch, "Condition")
        try:
            self.space.apply(patch)
            for detector in sorted(self.detectors, key=lambda d: d.name != expected):
                self.space.make(detector.targets)
                finding = detector.run(detector, self.space, condition)
                if finding:
                    return detector, finding
            return None
        finally:
            self.space.restore()

    def is_sound(self, detector):
        """Whether the detector passes where no fault is."""
        if detector.name not in self.sound:
            self.space.make(detector.targets)
            finding = detector.run(detector, self.space, "")
            if finding:
                print(f"    {detector.name} fails without a fault: {finding.what}", flush=True)
                return False
            self.sound.add(detector.name)
        return True


def cpu_seconds():
    """Of all processes that have ended: what a fault costs, whatever else the machine does."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def one_row(run, kind, patch, width):
    """Prints a row; returns "killed", "survived" or "error"."""
    begin, cpu = time.monotonic(), cpu_seconds()
    row = f"{kind + '/' + patch.stem:<{width}}"
    try:
        killed = run.kill(patch)
    except (workspace.BuildError, workspace.TimeOut) as error:
        print(f"{row}  ERROR: {error}", flush=True)
        return "error"
    seconds = f"{time.monotonic() - begin:>7.1f}  {cpu_seconds() - cpu:>7.1f}"
    if killed is None:
        print(f"{row}  {'-':>5}  {seconds}  SURVIVED", flush=True)
        return "survived"
    detector, finding = killed
    what = finding.what if len(finding.what) <= 110 else finding.what[:107] + "..."
    print(f"{row}  {finding.cases or '-':>5}  {seconds}  {detector.name}: {what}", flush=True)
    return "killed" if run.is_sound(detector) else "error"


def main():
    parser = argparse.ArgumentParser(prog="scripts/faults", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="ref|checker|NAME", help="default: all")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes at a time")
    parser.add_argument("--rotating", metavar="[K/]N", help="the K-th of N parts; without K the part follows from the commit")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "faults", help="folder of the copy and its build")
    parser.add_argument("--list", action="store_true", help="print the faults and what they are")
    parser.add_argument("--check", action="store_true", help="only whether every patch applies and has its header")
    options = parser.parse_args()
    faults = selected(options.names)
    if options.rotating:
        faults = rotated(faults, options.rotating)
    if options.list:
        for kind, path in faults:
            print(f"{kind}/{path.stem}\n    {header(path, 'Bug')}")
        return 0
    if options.check:
        bad = misfits(faults)
        print("\n".join(bad + [f"{len(faults)} faults, {len(bad)} misfits"]))
        return 1 if bad or not faults else 0
    if not faults:
        print("faults: nothing to do", file=sys.stderr)
        return 1
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))  # inherited by all that runs here
    begin, results = time.monotonic(), []
    width = max(len(kind + path.stem) + 1 for kind, path in faults)
    print(f"{'fault':<{width}}  {'cases':>5}  {'seconds':>7}  {'CPU':>7}  killed by")
    for kind in KINDS:
        chosen = [path for k, path in faults if k == kind]
        if not chosen:
            continue
        started, cpu = time.monotonic(), cpu_seconds()
        run = Run(kind, workspace.Workspace(ROOT, options.work.resolve() / kind, kind, options.jobs))
        print(f"{'(copied and built without a fault)':<{width}}  {'':>5}  {time.monotonic() - started:>7.1f}  "
              f"{cpu_seconds() - cpu:>7.1f}", flush=True)
        results += [(kind, path, one_row(run, kind, path, width)) for path in chosen]
    killed = sum(result == "killed" for *_, result in results)
    for wanted in ("survived", "error"):
        names = [f"{kind}/{path.stem}" for kind, path, result in results if result == wanted]
        if names:
            print(f"{wanted}: {' '.join(names)}")
    print(f"{killed} of {len(results)} faults killed in {time.monotonic() - begin:.0f} s")
    return 0 if killed == len(results) else 1


if __name__ == "__main__":
    sys.exit(main())
