"""What looks for faults, from cheap to costly. A detector is built, run, and either passes or names what failed."""
import concurrent.futures
import dataclasses
import os
import pathlib
import re
import signal
import sys

import workspace

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import invalid_corpus_test  # noqa: E402

LIMIT = 40  # seconds of CPU time for one program; the slowest takes a third of that without a fault
LONG_LIMIT = 400  # the same for the programs of property_tests


@dataclasses.dataclass
class Finding:
    """What failed, after how many cases (tests or files; 0: not counted)."""
    what: str
    cases: int


@dataclasses.dataclass
class Detector:
    """`run` takes this, a workspace and a hint where to look first; it returns a Finding, or None if nothing failed."""
    name: str
    targets: list
    run: object
    arguments: tuple = ()
    optional: bool = False  # left out where the tree does not have it: an optional package, a part to come
    limit: int = LIMIT
    lazy: bool = False  # built only where a fault has come past all the others


def program(space, target):
    return next(p for p in space.build.rglob(target) if p.is_file() and os.access(p, os.X_OK))


def run_gtest(detector, space, _hint):
    """The first failing test of a GoogleTest program; a crash counts against the test that was running."""
    command = [program(space, detector.targets[0]), "--gtest_fail_fast", "--gtest_color=no", *detector.arguments]
    environment = os.environ | {"RC_PARAMS": os.environ.get("RC_PARAMS", "noshrink=1"),
                                "FLATDT_COUNTEREXAMPLES": str(space.folder)}
    try:
        done = workspace.run(command, space.source, detector.limit, env=environment)
        output, how = done.stdout, ""
        if done.returncode == 0:
            return None
        if done.returncode < 0:
            how = f" ({signal.Signals(-done.returncode).name})"
    except workspace.TimeOut as late:
        output, how = str(late), " (time-out)"
    running = re.findall(r"^\[ RUN      \] (\S+)", output, re.MULTILINE)
    failed = re.search(r"^\[  FAILED  \] ([^\s,]+)", output, re.MULTILINE)
    what = failed.group(1) if failed else running[-1] if running else "before the first test"
    return Finding(what + how, running.index(what) + 1 if what in running else len(running))


def run_script(detector, space, _hint):
    """A program that exits 0, or prints FAILED and what failed, with `case N` in it where it counts."""
    replaced = {"FLATDT": program(space, "flatdt"), "CHECK": program(space, "flatdt-check"), "JOBS": space.jobs}
    command = [replaced.get(a, a) for a in detector.arguments]
    try:
        done = workspace.run(command, space.source, detector.limit)
    except workspace.TimeOut as late:
        return Finding("time-out: " + str(late)[-100:].strip(), 0)
    if done.returncode == 0:
        return None
    line = next((x for x in (done.stdout + done.stderr).splitlines() if x.startswith("FAILED ")), "FAILED without a word")
    number = re.match(r"FAILED case (\d+) of \d+: (.*)", line)
    return Finding(number.group(2), int(number.group(1))) if number else Finding(line[7:], 0)


def run_corpus(_detector, space, condition):
    """The first file of corpora/invalid whose record flatdt-check contradicts; those of the weakened condition first."""
    invalid = space.source / "corpora" / "invalid"
    folders = sorted(os.listdir(invalid), key=lambda folder: (folder != condition, folder))
    stems = [stem for folder in folders for stem in invalid_corpus_test.stems(str(invalid / folder))]
    check = str(program(space, "flatdt-check"))

    def attempt(stem):
        try:
            invalid_corpus_test.check_file(check, stem)
        except (invalid_corpus_test.Failure, OSError, ValueError, KeyError, TypeError) as failure:
            return str(failure)
        except invalid_corpus_test.subprocess.TimeoutExpired:
            return "time-out"
        return None

    with concurrent.futures.ThreadPoolExecutor(space.jobs) as pool:
        for number, (stem, complaint) in enumerate(zip(stems, pool.map(attempt, stems)), 1):
            if complaint is not None:
                pool.shutdown(wait=True, cancel_futures=True)
                return Finding(f"{os.path.relpath(stem, invalid)}: {complaint}", number)
    return None


def gtest(name, *arguments, optional=False):
    return Detector(name, [name], run_gtest, arguments, optional)


def last_resort(name, *arguments):
    return Detector(name, [name], run_gtest, arguments, optional=True, limit=LONG_LIMIT, lazy=True)


DETECTORS = {
    "ref": [
        gtest("ref_lexer_test"),
        gtest("ref_instance_format_test"),
        gtest("ref_triangulation_format_test"),
        gtest("ref_catalogue_test"),
        gtest("ref_svg_test"),
        gtest("ref_refutation_test"),
        gtest("ref_scene_test"),
        gtest("ref_lattice_test"),
        gtest("ref_plane_groups_test"),
        gtest("ref_group_analysis_test"),
        gtest("ref_group_delta_test"),
        gtest("ref_closest_vector_test"),
        gtest("ref_insertion_order_test"),
        gtest("ref_small_sites_test"),
        gtest("ref_circumradius_test"),
        gtest("ref_quotient_insertion_test"),
        gtest("ref_insertion_without_covers_test"),
        gtest("ref_families_degeneracy_test"),
        gtest("ref_predicates_test"),
        gtest("ref_cover_test"),
        Detector("import_test.sh", ["flatdt"], run_script, ("bash", "ref/tests/import_test.sh", "FLATDT")),
        Detector("agreement", ["flatdt", "flatdt-check"], run_script,
                 ("python3", "property_tests/agreement_test.py", "FLATDT", "CHECK", "corpora", "--jobs", "JOBS")),
        gtest("ref_triangulate_test"),
        gtest("ref_families_test"),
        gtest("ref_space_groups_test", optional=True),
        # What no test with an answer of its own has seen: another program's answers, then random specimens.
        last_resort("flatdt_oracle_tests", "--gtest_filter=RefAgainstOracle*"),
        last_resort("flatdt_properties", "--gtest_filter=-FreshSeed.*:Generators.*"),
    ],
    "checker": [
        Detector("corpora/invalid", ["flatdt-check"], run_corpus),
    ],
}
