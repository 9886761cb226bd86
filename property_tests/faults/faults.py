"""Seeded faults: every patch below ref/ and checker/ here is one plausible bug, and some test must notice it.

Each is applied to a copy of the tree and built there; the detectors run until one fails. Exit 0 only if every fault is
killed. A fault that does not apply or compile is an error, not a kill; so is one whose killer fails without it as well.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import time

sys.dont_write_bytecode = True

import detectors  # noqa: E402
import workspace  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
KINDS = ("ref", "checker")


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


class Run:
    def __init__(self, space):
        self.space, self.sound = space, set()

    def available(self, kind, existing=None):
        table = detectors.DETECTORS[kind]
        return [d for d in table if existing is None or all(t in existing for t in d.targets)]

    def prepare(self, kinds):
        self.detectors = {}

        def targets(existing):
            self.detectors = {kind: self.available(kind, existing) for kind in kinds}
            return sorted({t for kind in kinds for d in self.detectors[kind] for t in d.targets})

        self.space.prepare(targets)

    def kill(self, kind, patch):
        """The detector and its finding, or None if all pass."""
        try:
            self.space.apply(patch)
            for detector in self.detectors[kind]:
                self.space.make(detector.targets)
                finding = detector.run(detector, self.space)
                if finding:
                    return detector, finding
            return None
        finally:
            self.space.restore()

    def is_sound(self, detector):
        """Whether the detector passes where no fault is."""
        if detector.name not in self.sound:
            finding = detector.run(detector, self.space)
            if finding:
                print(f"    {detector.name} fails without a fault: {finding.what}", flush=True)
                return False
            self.sound.add(detector.name)
        return True


def one_row(run, kind, patch, width):
    """Prints a row; returns "killed", "survived" or "error"."""
    begin = time.monotonic()
    row = f"{kind + '/' + patch.stem:<{width}}"
    try:
        killed = run.kill(kind, patch)
    except (workspace.BuildError, workspace.TimeOut) as error:
        print(f"{row}  ERROR: {error}", flush=True)
        return "error"
    seconds = time.monotonic() - begin
    if killed is None:
        print(f"{row}  SURVIVED  {seconds:.1f} s", flush=True)
        return "survived"
    detector, finding = killed
    what = finding.what if len(finding.what) <= 110 else finding.what[:107] + "..."
    print(f"{row}  {finding.cases or '-':>5}  {seconds:>7.1f}  {detector.name}: {what}", flush=True)
    return "killed" if run.is_sound(detector) else "error"


def main():
    parser = argparse.ArgumentParser(prog="scripts/faults", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="ref|checker|NAME", help="default: all")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="processes at a time")
    parser.add_argument("--rotating", metavar="[K/]N", help="the K-th of N parts; without K the part follows from the commit")
    parser.add_argument("--work", type=pathlib.Path, default=ROOT / "build" / "faults", help="folder of the copy and its build")
    parser.add_argument("--list", action="store_true", help="print the faults and what they are")
    options = parser.parse_args()
    faults = selected(options.names)
    if options.rotating:
        faults = rotated(faults, options.rotating)
    if options.list:
        for kind, path in faults:
            text = path.read_text()
            print(f"{kind}/{path.stem}\n    " + text[5:text.index("\nPlausible:")].replace("\n ", ""))
        return 0
    if not faults:
        print("faults: nothing to do", file=sys.stderr)
        return 1
    begin = time.monotonic()
    run = Run(workspace.Workspace(ROOT, options.work.resolve(), options.jobs))
    run.prepare({kind for kind, _ in faults})
    print(f"copied and built in {time.monotonic() - begin:.0f} s", flush=True)
    width = max(len(kind + path.stem) + 1 for kind, path in faults)
    print(f"{'fault':<{width}}  {'cases':>5}  {'seconds':>7}  killed by")
    results = [(kind, path, one_row(run, kind, path, width)) for kind, path in faults]
    killed = sum(result == "killed" for *_, result in results)
    for wanted in ("survived", "error"):
        names = [f"{kind}/{path.stem}" for kind, path, result in results if result == wanted]
        if names:
            print(f"{wanted}: {' '.join(names)}")
    print(f"{killed} of {len(results)} faults killed in {time.monotonic() - begin:.0f} s")
    return 0 if killed == len(results) else 1


if __name__ == "__main__":
    sys.exit(main())
