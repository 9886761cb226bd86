"""Measures rows and prints the table (scripts/bench)."""
import argparse
import datetime
import json
import os
import pathlib
import platform
import statistics
import subprocess
import sys

from measure import Bench, Crashed, Failed
from rows import all_rows

ROOT = pathlib.Path(__file__).resolve().parents[2]


def figure(value):
    return f"{value:,.0f}" if abs(value) >= 100 else f"{value:.3g}"


def machine(bench):
    """What the figures hold for."""
    model = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")),
                 platform.machine())
    memory = int(next(line.split()[1] for line in open("/proc/meminfo") if line.startswith("MemTotal")))
    commit = subprocess.run(["git", "-C", str(ROOT), "rev-parse", "--short", "HEAD"], capture_output=True, text=True)
    return {"cpu": model, "cores": os.cpu_count(), "memory_gib": round(memory / 2**20), **bench.about(),
            "commit": commit.stdout.strip() or "unknown", "date": datetime.date.today().isoformat(),
            "load": round(os.getloadavg()[0], 1)}


def measure(row, bench):
    """The row as a dict, with what is missing said."""
    result = {"row": row.name, "work": row.work, "at_least": row.at_least, "aim": row.aim,
              "more_is_better": row.more_is_better, "unit": row.unit}
    try:
        measured = row.measure(bench)
    except Failed as failure:
        verdict = "FAILED" if isinstance(failure, Crashed) else "not measured"
        return {**result, "verdict": verdict, "note": str(failure), "runs": 0}
    value = statistics.median(measured.values)
    note = measured.note + (f"; {bench.cut_off()}" if measured.cut_off else "")
    return {**result, "median": value, "min": min(measured.values), "max": max(measured.values),
            "runs": len(measured.values), "verdict": row.verdict(value), "note": note}


HEADER = ("| row | work | median (min..max) | runs | at least | aim | | behind it |\n"
          "|---|---|---|---|---|---|---|---|")


def markdown(result):
    def bound(key):
        if result[key] is None:
            return ""
        return ("" if result["more_is_better"] else "at most ") + f"{result[key]:g}{result['unit']}"
    shown = "-"
    if result["runs"]:
        shown = f"**{figure(result['median'])}{result['unit']}** ({figure(result['min'])}..{figure(result['max'])})"
    return (f"| {result['row']} | {result['work']} | {shown} | {result['runs']} | {bound('at_least')} | {bound('aim')} | "
            f"{result['verdict']} | {result['note']} |")


def main():
    parser = argparse.ArgumentParser(
        prog="scripts/bench", description="Measure against peers, side by side, and print a table of ratios.",
        epilog="`scripts/bench --complexity --help` for time against the number of points.")
    parser.add_argument("rows", nargs="*", metavar="ROW", help="names of rows, or beginnings of them; default all")
    parser.add_argument("--quick", action="store_true", help="10,000 points instead of 100,000, and no rows of a million")
    parser.add_argument("--points", type=int, help="points of the large sets (memory and growth: also ten times as many)")
    parser.add_argument("--repetitions", type=int, default=5, help="runs of each row, default 5")
    parser.add_argument("--budget", type=float, default=1800, metavar="SECONDS", help="seconds of CPU time after which a row is cut off, default 1800")
    parser.add_argument("--list", action="store_true", help="list the rows")
    parser.add_argument("--json", type=pathlib.Path, help="write one line of JSON for each row to this file")
    parser.add_argument("--raw", type=pathlib.Path, help="write every single measurement to this file")
    parser.add_argument("--programs", type=pathlib.Path, default=ROOT / "build" / "bench", help=argparse.SUPPRESS)
    options = parser.parse_args()

    raw = open(options.raw, "w") if options.raw else None
    points = options.points or (10000 if options.quick else 100000)
    bench = Bench(options.programs.resolve(), ROOT / "corpora", points, options.repetitions, options.budget, raw)
    rows = all_rows(bench.names())
    for word in options.rows:
        if not any(row.name.startswith(word) for row in rows):
            parser.error(f"no row begins with {word}; --list lists them")
    rows = [row for row in rows if any(row.name.startswith(word) for word in options.rows or [""])]
    if options.quick:
        rows = [row for row in rows if not row.big]
    if options.list:
        for row in rows:
            print(f"{row.name}: {row.work}")
        return 0

    facts = machine(bench)
    print(f"{facts['cores']} x {facts['cpu']}, {facts['memory_gib']} GiB; {facts['compiler']}, {facts['flags']}; peer: "
          f"{facts['peer'] or 'not installed'}; commit {facts['commit']}; {points:,} points; user CPU time; load "
          f"{facts['load']} at the start\n\n{HEADER}", flush=True)
    failed = False
    lines = [{"machine": facts, "points": points}]
    for row in rows:
        print(f"bench: {row.name} ...", file=sys.stderr, flush=True)
        result = measure(row, bench)
        failed = failed or result["verdict"] == "FAILED"
        print(markdown(result), flush=True)
        lines.append(result)
        if options.json:
            options.json.write_text("".join(json.dumps(line) + "\n" for line in lines))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
