"""Tests of what scripts/bench makes of measurements: ratios, verdicts, budgets, tables, pictures. No benchmark is run."""
import pathlib
import stat
import sys
import tempfile
import unittest
import xml.dom.minidom

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from measure import Bench, Crashed, Failed, ratios
from plot import Panel, Scale, Series, picture
from rows import Measured, Row, against
from table import markdown, measure


def line(part, repetition, user, items=1):
    return {"experiment": "e", "part": part, "repetition": repetition, "user": user, "items": items}


class Figures(unittest.TestCase):
    def test_ratios_are_of_single_items_and_of_the_same_repetition(self):
        lines = [line("cgal", 0, 6, items=2), line("flatdt", 0, 1), line("cgal", 1, 8, items=2), line("flatdt", 1, 2),
                 line("flatdt", 2, 5)]
        self.assertEqual(ratios(lines, "cgal", "flatdt"), [3, 2])

    def test_verdicts_at_the_bounds(self):
        more = Row("r", "", None, at_least=1, aim=2)
        self.assertEqual([more.verdict(v) for v in (0.99, 1, 1.99, 2)], ["below", "ok", "ok", "aim"])
        less = Row("r", "", None, at_least=2, aim=1, more_is_better=False)
        self.assertEqual([less.verdict(v) for v in (2.01, 2, 1.01, 1)], ["below", "ok", "ok", "aim"])

    def test_the_table_shows_median_and_spread(self):
        row = Row("r", "w", lambda bench: Measured([3, 1, 2], "n"), at_least=1, aim=2)
        self.assertEqual(markdown(measure(row, None)), "| r | w | **2** (1..3) | 3 | 1 | 2 | aim | n |")


class Programs(unittest.TestCase):
    """A shell script in place of flatdt_bench."""

    def bench(self, body, budget=10):
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        program = folder / "property_tests" / "bench" / "flatdt_bench"
        program.parent.mkdir(parents=True)
        program.write_text("#!/bin/sh\n" + body)
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        return Bench(folder, folder, 10, 5, budget)

    OURS = '{"part":"flatdt","repetition":0,"user":2,"items":1}'
    PEER = '{"part":"cgal","repetition":0,"user":6,"items":1}'

    def test_a_ratio(self):
        measured = against("e", "cgal")(self.bench(f"echo '{self.OURS}'; echo '{self.PEER}'"))
        self.assertEqual((measured.values, measured.cut_off), ([3], False))

    def test_the_budget_keeps_whole_lines(self):
        bench = self.bench(f"echo '{self.OURS}'; echo '{self.PEER}'; printf '{self.OURS[:20]}'; while :; do :; done", budget=1)
        measured = against("e", "cgal")(bench)
        self.assertEqual((measured.values, measured.cut_off), ([3], True))

    def test_no_peer(self):
        with self.assertRaisesRegex(Failed, "peer not installed"):
            against("e", "cgal")(self.bench(f"echo '{self.OURS}'"))

    def test_cut_off_is_not_called_a_missing_peer(self):
        with self.assertRaisesRegex(Failed, "cut off"):
            against("e", "cgal")(self.bench(f"echo '{self.OURS}'; while :; do :; done", budget=1))

    def test_a_crash_is_no_figure(self):
        with self.assertRaisesRegex(Crashed, "exit 3: bad"):
            against("e", "cgal")(self.bench(f"echo '{self.OURS}'; echo bad >&2; exit 3"))

    def test_whole_processes(self):
        bench = self.bench("", budget=1)
        self.assertGreater(bench.whole_process([sys.executable, "-c", "sum(range(10**6))"])["user"], 0)
        with self.assertRaises(Crashed):
            bench.whole_process(["false"])
        with self.assertRaisesRegex(Failed, "cut off"):
            bench.whole_process([sys.executable, "-c", "while True: pass"])

    def test_waiting_ends_by_the_clock(self):
        bench = self.bench("exec sleep 60", budget=0.1)
        with self.assertRaisesRegex(Failed, "cut off"):
            against("e", "cgal")(bench)
        with self.assertRaisesRegex(Failed, "cut off"):
            bench.whole_process(["sleep", "60"])


class Pictures(unittest.TestCase):
    def test_ticks_are_inside(self):
        for values, log in (([1, 7], False), ([3, 4], True), ([1e-5, 2e3], True), ([5, 5], True), ([3.3, 3.4], True)):
            scale = Scale(values, 0, 100, log)
            ticks = scale.ticks()
            self.assertTrue(ticks, values)
            self.assertTrue(all(-1e-6 <= scale(t) <= 100 + 1e-6 for t in ticks), (values, ticks))

    def test_all_points_are_drawn(self):
        series = [Series("a<b", [(10, 1.0), (100, 20.0)]), Series("c", [(10, 2.0)])]
        text = picture("t", "n", [Panel("s", series, True, ("n log n", lambda n, log: n * log(n))), Panel("p", series, False)])
        svg = xml.dom.minidom.parseString(text)
        # Three points in each of two panels, two in the legend.
        self.assertEqual(len(svg.getElementsByTagName("circle")), 2 * 3 + 2)


if __name__ == "__main__":
    unittest.main()
