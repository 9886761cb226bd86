"""Time against the number of points on the ten 3-manifolds: uniform sets, and the moment curve (quadratically many cells).

Writes FAMILY.tsv and FAMILY.svg; with --plot only the pictures, from the data that are there.
"""
import argparse
import pathlib
import statistics
import sys

from measure import Bench, Failed
from plot import Panel, Series, picture
from rows import OTHER_MANIFOLDS

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANIFOLDS = ["torocosm"] + OTHER_MANIFOLDS
SIZES = {
    "uniform": [1000, 2000, 5000, 10000, 20000, 50000, 100000, 200000, 500000, 1000000],
    "moment-curve": [25, 50, 100, 150, 200, 300, 400, 600, 800, 1200],
}
COLUMNS = ["manifold", "points", "user_seconds", "least", "most", "runs", "cells"]


def measured(bench, family, manifold, points):
    lines, _ = bench.experiment("single", points, extra=["--manifold", manifold, "--family", family])
    times = [line["user"] for line in lines]
    if not times:
        raise bench.cut_off()
    return [manifold, points, statistics.median(times), min(times), max(times), len(times), lines[0]["cells"]]


def measure_family(bench, family, sizes, path):
    """All manifolds in turn for each size; a manifold that a budget cut off goes no further."""
    going = list(MANIFOLDS)
    with open(path, "w") as out:
        facts = bench.about()
        out.write(f"# {family}; user seconds, medians; {facts['compiler']}, {facts['flags']}\n")
        out.write("\t".join(COLUMNS) + "\n")
        for points in sizes:
            for manifold in list(going):
                print(f"complexity: {family} {points} {manifold}", file=sys.stderr, flush=True)
                try:
                    row = measured(bench, family, manifold, points)
                except Failed as failure:
                    print(f"complexity: {manifold}: {failure}", file=sys.stderr)
                    out.write(f"# {manifold} {points}: {failure}\n")
                    going.remove(manifold)
                    continue
                out.write("\t".join(f"{x:.6g}" if isinstance(x, float) else str(x) for x in row) + "\n")
                out.flush()


def read(path):
    """{manifold: [(points, seconds, cells)]}"""
    rows = {}
    for line in path.read_text().splitlines():
        if line.startswith("#") or line.startswith("manifold\t"):
            continue
        fields = dict(zip(COLUMNS, line.split("\t")))
        rows.setdefault(fields["manifold"], []).append(
            (int(fields["points"]), float(fields["user_seconds"]), int(fields["cells"])))
    return rows


def draw(family, folder):
    rows = read(folder / f"{family}.tsv")
    if not rows:
        raise Failed(f"{folder / family}.tsv has no data")
    times = [Series(m, [(n, s) for n, s, _ in data]) for m, data in rows.items()]
    if family == "uniform":
        second = Panel("microseconds per point", [Series(m, [(n, 1e6 * s / n) for n, s, _ in data])
                                                  for m, data in rows.items()], log_y=False)
        title, guide = "Uniform points: user time", ("n log n", lambda n, log: n * log(n))
    else:
        second = Panel("cells of the answer, all sheets", [Series(m, [(n, c) for n, _, c in data]) for m, data in rows.items()], log_y=True,
                       guide=("n^2", lambda n, log: n * n))
        title, guide = "Points of the moment curve: user time and size of the answer", ("n^2", lambda n, log: n * n)
    panels = [Panel("seconds", times, log_y=True, guide=guide), second]
    (folder / f"{family}.svg").write_text(picture(title, "points n", panels))


def main():
    parser = argparse.ArgumentParser(prog="scripts/bench --complexity", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="up to 10,000 points, 100 of the moment curve")
    parser.add_argument("--max-points", type=int, help="largest uniform set, default 1,000,000")
    parser.add_argument("--max-curve-points", type=int, help="largest set of the moment curve, default 1,200")
    parser.add_argument("--family", choices=sorted(SIZES), action="append", help="only this one")
    parser.add_argument("--repetitions", type=int, default=5, help="runs of each set, default 5")
    parser.add_argument("--budget", type=float, default=1800, metavar="SECONDS",
                        help="seconds of CPU time for the runs of one set, default 1800")
    parser.add_argument("--plot", action="store_true", help="measure nothing, draw the data that are there")
    parser.add_argument("-o", "--output", type=pathlib.Path, default=ROOT / "docs" / "performance", help="folder")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build" / "bench", help=argparse.SUPPRESS)
    options = parser.parse_args()
    most = {"uniform": options.max_points or (10000 if options.quick else 1000000),
            "moment-curve": options.max_curve_points or (100 if options.quick else 1200)}
    options.output.mkdir(parents=True, exist_ok=True)
    for family in options.family or SIZES:
        if not options.plot:
            bench = Bench(options.programs.resolve(), ROOT / "corpora", 0, options.repetitions, options.budget)
            measure_family(bench, family, [n for n in SIZES[family] if n <= most[family]], options.output / f"{family}.tsv")
        try:
            draw(family, options.output)
        except (Failed, FileNotFoundError) as failure:
            print(f"complexity: {failure}", file=sys.stderr)
            return 1
        print(options.output / f"{family}.svg")
    return 0


if __name__ == "__main__":
    sys.exit(main())
