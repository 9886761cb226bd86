"""The rows of the table: what is measured, what must be reached, what is wanted."""
import dataclasses
import pathlib
import statistics
import tempfile
import typing

from measure import Failed, per_item, ratios

OTHER_MANIFOLDS = ["dicosm", "tricosm", "tetracosm", "hexacosm", "didicosm", "first-amphicosm", "second-amphicosm",
                   "first-amphidicosm", "second-amphidicosm"]


@dataclasses.dataclass
class Measured:
    values: list        # one figure for each run
    note: str = ""      # what stands behind the figures
    cut_off: bool = False


@dataclasses.dataclass
class Row:
    name: str
    work: str
    measure: typing.Callable  # of a Bench; gives Measured or raises Failed
    at_least: float = None    # None: for information
    aim: float = None
    more_is_better: bool = True
    unit: str = ""
    big: bool = False         # not in quick runs

    def verdict(self, value):
        if self.at_least is None:
            return ""
        reached = (lambda bound: value >= bound) if self.more_is_better else (lambda bound: value <= bound)
        return "aim" if reached(self.aim) else "ok" if reached(self.at_least) else "below"


def rate(lines, part):
    """Items per second by the median, in words."""
    times = per_item(lines, part)
    if not times:
        return f"{part}: no run"
    value = 1 / statistics.median(times.values())
    return f"{part} {value:,.0f}/s" if value >= 10 else f"{part} {value:.2g}/s"


def against(experiment, peer, ours="flatdt"):
    """How many times as long the peer takes for an item as we do."""
    def measure(bench):
        lines, cut_off = bench.experiment(experiment)
        if not any(line["part"] == peer for line in lines):
            if cut_off:
                raise Failed(f"{bench.cut_off()}; " + rate(lines, ours))
            raise Failed("peer not installed; " + rate(lines, ours))
        values = ratios(lines, peer, ours)
        if not values:
            raise Failed(f"{bench.cut_off()}; " + rate(lines, ours) + ", " + rate(lines, peer))
        return Measured(values, rate(lines, ours) + ", " + rate(lines, peer), cut_off)
    return measure


def manifold(name):
    def measure(bench):
        lines, cut_off = bench.experiment("manifolds")
        values = ratios(lines, name, "torocosm")
        if not values:
            raise bench.cut_off()
        return Measured(values, rate(lines, name) + ", " + rate(lines, "torocosm"), cut_off)
    return measure


def growth(bench):
    lines, cut_off = bench.experiment("growth")
    values = [10 * v for v in ratios(lines, "flatdt-tenfold", "flatdt")]
    if not values:
        raise Failed(f"{bench.cut_off()}; " + rate(lines, "flatdt"))
    parts = sorted({line["part"] for line in lines})
    peers = [10 * v for v in ratios(lines, "cgal-tenfold", "cgal")]
    note = ", ".join(rate(lines, part) for part in parts)
    if peers:
        note += f"; cgal grows {statistics.median(peers):.3g} times"
    return Measured(values, note, cut_off)


def memory(bench):
    """Whole processes: peak memory less that of a process that does nothing."""
    points = 10 * bench.points
    values, inputs, peers = [], [], []
    parts = ["flatdt"] + (["cgal"] if bench.about()["peer"] else [])
    for _ in range(bench.repetitions):
        empty = bench.memory("nothing", points)["peak_kb"]
        for part in parts:
            used = bench.memory(part, points)
            figure = 1024 * (used["peak_kb"] - empty) / used["items"]
            if part == "cgal":
                peers.append(figure)
            else:
                values.append(figure)
                inputs.append(1024 * (used["input_kb"] - empty) / used["items"])
    note = f"of these the exact input {statistics.median(inputs):.0f}"
    if peers:
        note += f"; cgal {statistics.median(peers):.0f}"
    return Measured(values, f"{points:,} points; " + note)


def memory_process(bench):
    """`flatdt triangulate` on a file, from start to end: peak memory, by the difference of ten times the points and the points.

    Not less a run on one point: the peak that wait4() tells is at least that of this program, which the child is forked from.
    """
    few, many = bench.points, 10 * bench.points
    with tempfile.TemporaryDirectory(prefix="flatdt-bench-") as folder:
        folder = pathlib.Path(folder)
        runs = {}
        for n in (few, many):
            instance = bench.point_set_file(folder, "uniform", 3, n)
            command = [bench.flatdt, "triangulate", "--quiet", instance, "-o", folder / "t.triangulation"]
            runs[n] = [bench.whole_process(command) for _ in range(bench.repetitions)]
    values = [1024 * (much["peak_kb"] - little["peak_kb"]) / (many - few) for little, much in zip(runs[few], runs[many])]
    middle = lambda n, key: statistics.median(run[key] for run in runs[n])
    return Measured(values, "; ".join(f"{n:,} points {middle(n, 'peak_kb') / 1024:,.1f} MiB, {middle(n, 'user'):.3g} s"
                                      for n in (few, many)))


def check_process(bench):
    """flatdt-check over flatdt triangulate, both from files, in turns."""
    with tempfile.TemporaryDirectory(prefix="flatdt-bench-") as folder:
        folder = pathlib.Path(folder)
        instance = bench.point_set_file(folder, "uniform", 3, bench.points)
        triangulation = folder / "t.triangulation"
        values, checks, makes = [], [], []
        for _ in range(bench.repetitions):
            make = bench.whole_process([bench.flatdt, "triangulate", "--quiet", instance, "-o", triangulation])
            check = bench.whole_process([bench.flatdt_check, instance, triangulation])
            values.append(check["user"] / make["user"])
            checks.append(check)
            makes.append(make)
        size = triangulation.stat().st_size
    middle = lambda runs, key: statistics.median(run[key] for run in runs)
    return Measured(values, f"check {middle(checks, 'user'):.3g} s, {middle(checks, 'peak_kb') / 1024:.0f} MB; triangulate "
                            f"{middle(makes, 'user'):.3g} s, {middle(makes, 'peak_kb') / 1024:.0f} MB; file {size / 1e6:.3g} MB")


def long_cells(bench):
    """Milliseconds for each instance: the median of its runs; the row is the worst instance."""
    lines, cut_off = bench.experiment("long-cells")
    parts = sorted({line["part"] for line in lines})
    if not parts:
        raise bench.cut_off()
    each = {part: 1000 * statistics.median(per_item(lines, part).values()) for part in parts}
    worst = max(each, key=each.get)
    values = [1000 * v for v in per_item(lines, worst).values()]
    over = sum(1 for v in each.values() if v > 50)
    return Measured(values, f"worst of {len(parts)} instances: {worst}; median instance "
                            f"{statistics.median(each.values()):.3g} ms; {over} over 50 ms", cut_off)


def didicosm_million(bench):
    """Triangulated and VERIFIED, whole processes, once."""
    points = 10 * bench.points
    with tempfile.TemporaryDirectory(prefix="flatdt-bench-") as folder:
        instance, triangulation = pathlib.Path(folder) / "d.instance", pathlib.Path(folder) / "d.triangulation"
        bench.whole_process([bench.flatdt, "generate", "--manifold", "didicosm", "--points", points, "--seed", "1",
                             "-o", instance])
        make = bench.whole_process([bench.flatdt, "triangulate", "--quiet", instance, "-o", triangulation])
        check = bench.whole_process([bench.flatdt_check, instance, triangulation])
        size = triangulation.stat().st_size
    return Measured([make["user"] + check["user"]],
                    f"{points:,} points VERIFIED: triangulate {make['user']:.3g} s, {make['peak_kb'] / 1e6:.2g} GB; check "
                    f"{check['user']:.3g} s, {check['peak_kb'] / 1e6:.2g} GB; file {size / 1e6:.3g} MB")


def all_rows(experiments):
    """`experiments`: the names that flatdt_bench knows."""
    rows = [
        Row("batch-3d-uniform", "3-torus, uniform: points/s over CGAL's, large-point-set mode",
            against("batch-3d-uniform", "cgal"), 1.0, 1.8),
        Row("batch-3d-rounded-grid", "3-torus, grid rounded to doubles: the same", against("batch-3d-rounded-grid", "cgal"),
            10, 20),
        Row("batch-3d-integer-grid", "3-torus, integer grid: the same", against("batch-3d-integer-grid", "cgal"), 1.0, 2),
        Row("batch-2d-uniform", "2-torus, uniform: points/s over CGAL's hierarchy",
            against("batch-2d-uniform", "cgal-hierarchy"), 0.7, 1.0),
        Row("batch-2d-uniform-range", "the same over CGAL without hierarchy", against("batch-2d-uniform", "cgal")),
    ]
    for d, at_least, aim in ((3, 10, 30), (2, 2, 5)):
        for n in (1, 2, 4, 8, 16):
            bounds = (at_least, aim) if n > 1 else (None, None)
            rows.append(Row(f"small-{d}d-{n}", f"whole triangulations/s of {n} uniform points, {d}D, over CGAL's",
                            against(f"small-{d}d-{n}", "cgal"), *bounds))
            rows.append(Row(f"small-{d}d-{n}-with-analysis", "the same, the group analysed each time",
                            against(f"small-{d}d-{n}", "cgal", ours="flatdt-with-analysis")))
    for name in OTHER_MANIFOLDS:
        rows.append(Row(f"manifold-{name}", f"{name}, uniform: time per orbit over the 3-torus'", manifold(name), 1.5, 1.2,
                        more_is_better=False))
    for name in experiments:
        if name.startswith("crystal-"):
            rows.append(Row(name, f"crystal {name[8:]}: covering engine's time over the default's",
                            against(name, "covering"), 20, 100))
    rows += [
        Row("memory", "3-torus, uniform: peak memory, bytes per point", memory, 400, 300, more_is_better=False,
            unit=" B", big=True),
        Row("memory-process", "the same for the whole process `flatdt triangulate`, from file to file", memory_process, 400,
            300, more_is_better=False, unit=" B", big=True),
        Row("growth", "3-torus, uniform: time for ten times the points over time", growth, 12, 11, more_is_better=False,
            big=True),
        Row("checking-3d-uniform", "checking in memory, 3D uniform: CGAL is_valid's time over ours",
            against("checking-3d-uniform", "cgal"), 2, 5),
        Row("checking-3d-rounded-grid", "checking the rounded grid: the same", against("checking-3d-rounded-grid", "cgal"),
            10, 20),
        Row("checking-2d-uniform", "checking in memory, 2D uniform: the same (CGAL does not test the Delaunay property)",
            against("checking-2d-uniform", "cgal")),
        Row("check-process", "flatdt-check over flatdt triangulate, whole processes, 3-torus uniform", check_process, 0.5,
            0.25, more_is_better=False),
        Row("long-cells", "1 to 20 points in cells 1 : 10^6, the slowest", long_cells, 50, 5, more_is_better=False,
            unit=" ms"),
        Row("didicosm-million", "didicosm, uniform, ten times the points: triangulate and check, user seconds",
            didicosm_million, more_is_better=False, unit=" s", big=True),
    ]
    return rows
