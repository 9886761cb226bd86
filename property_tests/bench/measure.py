"""Measurements as other processes give them: experiments of flatdt_bench, and whole processes."""
import json
import os
import pathlib
import resource
import signal
import subprocess
import tempfile
import threading
import time


class Failed(Exception):
    """A measurement that there is not, with the reason."""


class Crashed(Failed):
    """A program failed: not for want of time or of a peer."""


class Bench:
    """Runs programs of a build; remembers the experiments that several rows share.

    `budget`: seconds of CPU time for one process, so that a busy machine cuts off no more than an idle one; and ten times
    as many by the clock, for a process that waits.
    """

    def __init__(self, programs, corpora, points, repetitions, budget, raw=None):
        self.flatdt = str(programs / "ref" / "flatdt")
        self.flatdt_check = str(programs / "checker" / "flatdt-check")
        self.program = str(programs / "property_tests" / "bench" / "flatdt_bench")
        self.corpora = str(corpora)
        self.points, self.repetitions, self.budget = points, repetitions, budget
        self.raw = raw
        self.known = {}

    def limited(self):
        """Runs in the child: the soft limit ends it by SIGXCPU."""
        seconds = max(1, round(self.budget))
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))

    def cut_off(self):
        return Failed(f"cut off after {self.budget:g} s of CPU time")

    def about(self):
        return json.loads(subprocess.run([self.program, "about"], check=True, capture_output=True, text=True).stdout)

    def names(self):
        """All experiments of flatdt_bench."""
        done = subprocess.run([self.program, "list", "--corpora", self.corpora], check=True, capture_output=True, text=True)
        return [line.split(":")[0] for line in done.stdout.splitlines()]

    def experiment(self, name, points=None, repetitions=None, extra=()):
        """The measurements of an experiment: a list of dicts, and whether the budget cut it off."""
        key = (name, points, repetitions, tuple(extra))
        if key not in self.known:
            self.known[key] = self.lines(["run", name, *extra], points, repetitions)
        return self.known[key]

    def memory(self, part, points):
        """Peak memory of a process that does one part."""
        lines, cut_off = self.lines(["memory", part], points, None)
        if cut_off:
            raise self.cut_off()
        return lines[0]

    def lines(self, arguments, points, repetitions):
        command = [self.program, *arguments, "--points", str(points or self.points), "--repetitions",
                   str(repetitions or self.repetitions), "--corpora", self.corpora]
        with tempfile.TemporaryFile("w+") as out, tempfile.TemporaryFile("w+") as err:
            child = subprocess.Popen(command, stdout=out, stderr=err, preexec_fn=self.limited)
            try:
                code = child.wait(timeout=10 * self.budget)
                cut_off = code == -signal.SIGXCPU
            except subprocess.TimeoutExpired:
                child.kill()
                child.wait()
                cut_off = True
            out.seek(0)
            text = out.read()
            err.seek(0)
            complaint = err.read().strip()
        # A line that the budget cut in two is no measurement.
        lines = [json.loads(line) for line in text.splitlines() if line.endswith("}")]
        if self.raw is not None:
            for line in lines:
                self.raw.write(json.dumps(line) + "\n")
            self.raw.flush()
        if not cut_off and code != 0:
            raise Crashed(f"exit {code}: " + (complaint.splitlines() or ["no message"])[-1])
        return lines, cut_off

    def whole_process(self, command):
        """User seconds, CPU seconds, seconds by the clock, peak kB of a process from start to end."""
        begin = time.monotonic()
        with tempfile.TemporaryFile() as err:
            child = subprocess.Popen([str(word) for word in command], stdout=subprocess.DEVNULL, stderr=err,
                                     preexec_fn=self.limited)
            timer = threading.Timer(10 * self.budget, child.kill)
            timer.start()
            _, status, used = os.wait4(child.pid, 0)
            timer.cancel()
            child.returncode = os.waitstatus_to_exitcode(status)
            err.seek(0)
            complaint = err.read().decode(errors="replace").strip()
        wall = time.monotonic() - begin
        if child.returncode == -signal.SIGXCPU or wall >= 10 * self.budget:
            raise self.cut_off()
        if child.returncode != 0:
            raise Crashed(f"{pathlib.Path(command[0]).name}: exit {child.returncode}: {complaint}")
        result = {"command": [str(word) for word in command], "user": used.ru_utime,
                  "cpu": used.ru_utime + used.ru_stime, "wall": wall, "peak_kb": used.ru_maxrss}
        if self.raw is not None:
            self.raw.write(json.dumps(result) + "\n")
            self.raw.flush()
        return result

    def point_set_file(self, folder, name, dimension, points):
        """A point set on the torus as an instance file."""
        path = folder / f"{name}-{dimension}d-{points}.instance"
        with open(path, "w") as out:
            subprocess.run([self.program, "instance", name, str(dimension), "--points", str(points)], check=True, stdout=out)
        return path


def per_item(lines, part):
    """User seconds for one item, by repetition."""
    return {line["repetition"]: line["user"] / line["items"] for line in lines if line["part"] == part}


def ratios(lines, numerator, denominator):
    """time(numerator) / time(denominator) for one item each, from the repetitions that have both."""
    above, below = per_item(lines, numerator), per_item(lines, denominator)
    return [above[k] / below[k] for k in sorted(above) if k in below]
