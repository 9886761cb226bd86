#!/usr/bin/env python3
"""No input may crash, hang or exhaust memory: hostile_test.py FLATDT-CHECK FLATDT [--sanitized]

Makes hostile files and runs both programs on them, each with a limit of CPU time and (but under sanitizers, which reserve
address space) a memory limit. Demands the exit code, a reason with file:line on standard error where a file is at fault,
and that a failed `-o` leaves nothing behind. Standard library only.   Source: FORMAT.md, "Programs", "Lexical rules".
"""

import gzip
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

CHECK, FLATDT = sys.argv[1:3]
SANITIZED = "--sanitized" in sys.argv or os.environ.get("FLATDT_SANITIZED") == "1"
SECONDS = 60 if SANITIZED else 10
MEMORY = 2 << 30

INSTANCE = """flatdt-instance 1
dimension 2
manifold torus
generators 2
  1 0 1  0 1 0
  1 0 0  0 1 1
metric 1 0 1
points 2
  1/10 0.25
  0x1.8p-2 -3e-1
"""
TRIANGULATION = """flatdt-triangulation 1
subgroup 2
  1 0 3  0 1 0
  1 0 0  0 1 3
elements 3
  1 0 0  0 1 0
  1 0 1  0 1 0
  1 0 0  0 1 1
cells 1
  0 0  0 1  0 2
"""
complaints, runs, slowest = [], 0, (0.0, "")


def limit():
    if not SANITIZED:
        resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 1))


def complain(name, what):
    complaints.append(f"{name}: {what}")
    print(complaints[-1], flush=True)


def run(name, command, codes, stdin=None, stdout=subprocess.PIPE, fault=None):
    """Runs a command; codes are the exit codes allowed; fault: the file that standard error must name with a line."""
    global runs, slowest
    runs += 1
    start = time.monotonic()
    feed = {"input": stdin} if stdin is not None else {"stdin": subprocess.DEVNULL}
    try:
        result = subprocess.run(command, stdout=stdout, stderr=subprocess.PIPE, timeout=10 * SECONDS, preexec_fn=limit, **feed)
    except subprocess.TimeoutExpired:
        return complain(name, f"no answer after {10 * SECONDS} s")
    slowest = max(slowest, (time.monotonic() - start, name))
    message = result.stderr.decode("utf-8", "replace")
    output = (result.stdout or b"").decode("utf-8", "replace")
    if result.returncode == -signal.SIGXCPU:
        return complain(name, f"no answer after {SECONDS} s of CPU time")
    if result.returncode not in codes:
        return complain(name, f"exit {result.returncode}, not {codes}: {message[-300:]}")
    if "runtime error:" in message or "Sanitizer" in message:
        return complain(name, message[:600])
    if result.returncode in (2, 3):
        if not message.strip():
            complain(name, "no reason on standard error")
        elif len(message) > 100000:
            complain(name, f"{len(message)} bytes on standard error")
        elif fault and not re.search(re.escape(fault) + r":[0-9]+: \S", message) and result.returncode == 2:
            complain(name, f"no {fault}:line: reason in {message[:300]!r}")
    if fault is not None and command[0] == CHECK and stdout == subprocess.PIPE:
        word = {0: "VERIFIED", 1: "REFUTED", 2: "MALFORMED", 3: "UNKNOWN"}[result.returncode]
        if "--json" not in command and output.rstrip("\n").split("\n")[-1] != "s " + word:
            complain(name, f"exit {result.returncode}, but the last line is {output[-100:]!r}")
    return result


def write(path, data):
    with open(path, "wb") as out:
        out.write(data if isinstance(data, bytes) else data.encode("ascii"))
    return path


def hostile_instance(name, data, codes=(2,), draw=True, line=True):
    """All readers of an instance refuse it in the same way. codes: allowed exit codes."""
    path = write("bad.instance", data)
    good = write("good.triangulation", TRIANGULATION)
    fault = path if line else None
    run(name + " check", [CHECK, path, good], codes, fault=path if line else "")
    codes = [c for c in codes if c != 1]  # flatdt refutes nothing
    run(name + " info", [FLATDT, "info", path], codes, fault=fault)
    result = run(name + " triangulate", [FLATDT, "triangulate", path, "-o", "out.triangulation"], codes, fault=fault)
    if result and result.returncode and os.path.exists("out.triangulation"):
        complain(name, "triangulate failed and left its output")
    if draw:
        run(name + " draw", [FLATDT, "draw", path, good, "-o", "out.svg"], codes, fault=fault)
    for left in os.listdir("."):
        if left not in KEEP:
            if left not in ("bad.instance", "bad.triangulation", "good.triangulation", "out.triangulation", "out.svg"):
                complain(name, f"left {left} behind")
            os.remove(left)


def hostile_triangulation(name, data, codes=(2,), line=True):
    path = write("bad.triangulation", data)
    run(name + " check", [CHECK, "good.instance", path], codes, fault=path if line else "")
    run(name + " draw", [FLATDT, "draw", "good.instance", path, "-o", "out.svg"], codes if codes == (2,) else (0, 2, 3),
        fault=path if line else None)
    for left in ("out.svg", path):
        if os.path.exists(left):
            os.remove(left)


def token_ends(text):
    """Where tokens end, the last one left out: a file cut there is short."""
    return [m.end() for m in re.finditer(r"\S+", text)][:-1]


def instance(points="1\n0 0", generators=None, metric="1 0 1", dimension=2, name="torus"):
    listed = "" if generators is None else f"generators {len(generators)}\n" + "\n".join(generators) + "\n"
    return (f"flatdt-instance 1\ndimension {dimension}\n" + (f"manifold {name}\n" if name else "") + listed +
            (f"metric {metric}\n" if metric else "") + f"points {points}\n")


X, Y = "1 0 1 0 1 0", "1 0 0 0 1 1"


def primes(n, start):
    found, k = [], start
    while len(found) < n:
        if all(k % p for p in range(2, int(k ** 0.5) + 1)):
            found.append(k)
        k += 1
    return found


def truncated():
    for end in token_ends(INSTANCE):
        # A cut is malformed also where a token could have ended; after the last point's first number, too.
        for tail in ("", "\n"):
            hostile_instance(f"instance cut at {end}{'+LF' if tail else ''}", INSTANCE[:end] + tail, draw=False)
    hostile_instance("instance without last white space", INSTANCE.rstrip("\n"))
    for end in token_ends(TRIANGULATION):
        for tail in ("", "\n"):
            hostile_triangulation(f"triangulation cut at {end}{'+LF' if tail else ''}", TRIANGULATION[:end] + tail)
    hostile_triangulation("triangulation without last white space", TRIANGULATION.rstrip("\n"))


def bytes_():
    noise = bytes((k * k * 31 + k * 7 + k // 256) % 256 for k in range(100000))
    for name, data in {
            "empty": b"", "NUL": b"\0", "many NULs": b"\0" * 1000000, "noise": noise, "long line": b"x" * 10_000_000,
            "white space": b" \n" * 2_000_000, "one long comment": b"#" + b"c" * 10_000_000, "UTF-16": INSTANCE.encode("utf-16"),
            "many comments": b"#\n" * 3_000_000, "ELF": b"\x7fELF" + noise[:5000]}.items():
        hostile_instance("instance " + name, data, draw=False)
        hostile_triangulation("triangulation " + name, data)
    for name, data in {"instance": INSTANCE, "triangulation": TRIANGULATION}.items():
        hostile = hostile_instance if name == "instance" else hostile_triangulation
        hostile(name + " BOM", b"\xef\xbb\xbf" + data.encode())
        hostile(name + " noise after", data.encode() + noise)
        for at in range(0, len(data), 17):
            hostile(f"{name} NUL at {at}", data[:at].encode() + b"\0" + data[at:].encode())


def counts():
    for word in ("1000000000000000000", "9" * 4000, "18446744073709551615", "18446744073709551616", "4294967296", "-1", "-2", "2.5"):
        hostile_instance(f"points {word[:20]}", instance(f"{word}\n0 0"))
        hostile_instance(f"generators {word[:20]}", INSTANCE.replace("generators 2", "generators " + word))
        for section in ("subgroup 2", "elements 3", "cells 1"):
            hostile_triangulation(f"{section[:-2]} {word[:20]}", TRIANGULATION.replace(section, section[:-1] + word))
        if not word.startswith("2."):
            hostile_triangulation(f"index {word[:20]}", TRIANGULATION.replace("0 1  0 2", f"0 1  0 {word}"))
    # At the limits a count is good, but memory must not grow with it.
    hostile_instance("points 10^8, none there", instance("100000000\n0 0"))
    hostile_triangulation("elements 10^8, none there", TRIANGULATION.replace("elements 3", "elements 100000000"))
    hostile_triangulation("cells 10^9, none there", TRIANGULATION.replace("cells 1", "cells 1000000000"))


def numbers():
    digits = "7" * 1_000_000
    for name, word in {
            "million digits": digits, "million-digit denominator": "1/" + digits, "million-digit decimal": "0." + digits,
            "million-digit hex": "0x" + digits, "zero denominator": "1/0", "zero denominator, long": "1/" + "0" * 4000,
            "exponent 1e999999999": "1e999999999", "exponent 1e-999999999": "1e-999999999", "exponent of 4000 digits": "1e" + "9" * 4000,
            "zero to a huge exponent": "0e999999999", "hex exponent p999999999": "0x1p999999999", "hex exponent p-999999999": "0x1p-999999999",
            "hex exponent of 4000 digits": "0x1p-" + "9" * 4000, "exponent 2^64": "1e18446744073709551616", "exponent -2^31": "1e-2147483648",
            "exponent 2^64 + 1, hex": "0x1p18446744073709551617"}.items():
        hostile_instance("coordinate " + name, instance(f"1\n0 {word}"))
        hostile_instance("metric " + name, instance(metric=f"1 0 {word}"), draw=False)
        hostile_instance("generator " + name, instance(generators=[X, f"1 0 0 0 1 {word}"]), draw=False)
        hostile_triangulation("subgroup " + name, TRIANGULATION.replace("0 1 3", f"0 1 {word}"))
        hostile_triangulation("element " + name, TRIANGULATION.replace("1 0 1  0 1 0", f"1 0 1  0 1 {word}"))


def colliding_elements(n):
    """Translations whose low two limbs cancel in the SplitMix chain that once hashed elements: quadratic time then."""
    mask = (1 << 64) - 1

    def mix(x):
        x = ((x ^ (x >> 30)) * 0xbf58476d1ce4e5b9) & mask
        x = ((x ^ (x >> 27)) * 0x94d049bb133111eb) & mask
        return x ^ (x >> 31)

    state = mix(2)
    rows = "".join(f"\n1 0 0x{a + ((mix(state ^ a) ^ 0x123456789abcdef1) << 64):x} 0 1 0" for a in range(1, n + 1))
    return f"flatdt-triangulation 1\nelements {n}{rows}\ncells 0\n"


def cluster_and_gap(cluster, gap, length):
    """Each point in the gap is in conflict with a multiple of `length` lifts of few cells."""
    points = [f"{k * 619 % 1024}/1024 {k * 377 % 1021}/1021 {k * 233 % 1019}/{1019 * length}" for k in range(cluster)]
    points += [f"{k * 619 % 1024}/1024 {k * 377 % 1021}/1021 {k + 1}/{gap + 1}" for k in range(gap)]
    return instance(f"{len(points)}\n" + "\n".join(points), None, f"1 0 0 1 0 {length ** 2}", 3, "torocosm")


def sizes():
    """Good grammar, hard numbers. Refusals by admissibility are 2, limits of a program 3, and an answer is welcome."""
    answers = (0, 1, 2, 3)
    big = "7" * 4000
    hostile_instance("10^6 generators", instance(generators=["1 0 1 0 1 0"] * 1_000_000), draw=False)
    hostile_instance("10,001 generators", instance(generators=[X] * 10001), draw=False)
    denominators = primes(10000, 10 ** 6)
    many = [f"1 0 1/{p} 0 1 0" for p in denominators[:-1]] + [Y]
    hostile_instance("10,000 generators, different primes", instance(generators=many), answers, draw=False, line=False)
    long_ = [f"1 0 1/{10 ** 60 + 2 * k + 1} 0 1 0" for k in range(9999)] + [Y]
    hostile_instance("10,000 generators, long denominators", instance(generators=long_), answers, draw=False, line=False)
    longest = [f"1 0 1/{10 ** 4000 + 2 * k + 1} 0 1 0" for k in range(500)] + [Y]
    hostile_instance("500 generators, denominators of 4000 digits", instance(generators=longest), answers, draw=False, line=False)
    screws = [f"-1 0 0 0 0 -1 0 0 0 0 1 {2 * k + 1}/2" for k in range(3000)] + ["1 0 0 1 0 1 0 0 0 0 1 0", "1 0 0 0 0 1 0 1 0 0 1 0"]
    hostile_instance("3,000 screws", instance("1\n0 0 0", screws, "1 0 0 1 0 1", 3, "dicosm"), answers, draw=False, line=False)
    hostile_instance("coordinates of 4,000 digits", instance(f"3\n{big} -{big}\n{big[:-1]}1 1/{big}\n1/{big[:-1]}1 {big}/3"), answers, line=False)
    hostile_instance("coordinates 1e1100 and 1e-1100", instance("2\n1e1100 1e-1100\n0x1p4400 0x1p-4400"), answers, line=False)
    hostile_instance("huge Gram entries", instance("2\n0 0\n1/3 2/7", metric=f"{big} {big[:-10]} {big}"), answers, line=False)
    hostile_instance("tiny Gram entries", instance("2\n0 0\n1/3 2/7", metric=f"1/{big} 0 1/{big[:-1]}"), answers, line=False)
    hostile_instance("ill-conditioned metric", instance("2\n0 0\n1/3 2/7", metric="1 0 1e1100"), answers, line=False)
    hostile_instance("nearly singular metric", instance("2\n0 0\n1/3 2/7", metric=f"1 {10 ** 1000 - 1}/{10 ** 1000} 1"), answers, line=False)
    hostile_instance("nearly singular metric, negative", instance(metric=f"1 {10 ** 1000 + 1}/{10 ** 1000} 1"), line=True)
    hostile_instance("lattice 1 : 10^1000", instance("2\n0 0\n1/3 2/7", generators=["1 0 1e1000 0 1 0", Y], name=None), answers, line=False)
    hostile_instance("skewed lattice", instance("2\n0 0\n1/3 2/7", generators=[X, "1 0 1e1000 0 1 1"]), answers, line=False)
    hostile_instance("lattice 1 : 1 : 10^900", instance("1\n0 0 0", None, "1 0 0 1 0 1e900", 3, "P41"), answers, draw=False, line=False)
    hostile_instance("dense translations", instance(generators=[X, Y, f"1 0 1/{10 ** 900 + 1} 0 1 0"]), answers, line=False)
    shear = ["1 1 0 0 1 0", "1 0 0 1 1 0", X, Y]
    hostile_instance("free group", instance(generators=shear), (2,), line=False)
    order = "3/5 -4/5 0 4/5 3/5 0"
    hostile_instance("infinite rotation 10,000 times", instance(generators=[order] * 9998 + [X, Y]), (2,), draw=False, line=False)
    hostile_instance("big linear part", instance(generators=[X, Y, f"{big} 1 0 1 {big} 0"]), (2,), draw=False, line=False)
    hostile_instance("5,000 equal points", instance("5000\n" + "0 0\n" * 5000), answers, line=False)
    hostile_instance("1,000 points on a line", instance("1000\n" + "".join(f"{k}/1000 0\n" for k in range(1000))), answers, line=False)
    write("gap.instance", cluster_and_gap(1000, 20, 10 ** 5))
    run("1,000 points in a cluster and 20 in a gap of 10^5 periods", [FLATDT, "triangulate", "gap.instance", "-o", "out"], [0])
    os.remove("gap.instance")
    os.remove("out")
    hostile_triangulation("10^6 generators of a subgroup", TRIANGULATION.replace("subgroup 2", "subgroup 1000000" + "\n1 0 3 0 1 0" * 999998))
    same = "subgroup 10000" + "\n1 0 3 0 1 0" * 9998
    hostile_triangulation("10,000 generators of a subgroup", TRIANGULATION.replace("subgroup 2", same), (1, 3), line=False)
    outside = "subgroup 10000" + "".join(f"\n1 0 1/{p} 0 1 0" for p in denominators[:9998])
    hostile_triangulation("10,000 generators outside", TRIANGULATION.replace("subgroup 2", outside), (1, 3), line=False)
    huge = TRIANGULATION.replace("1 0 3  0 1 0", "1 0 1e1000  0 1 0").replace("1 0 0  0 1 3", "1 0 0  0 1 1e1000")
    hostile_triangulation("subgroup of index 10^2000", huge, (1, 3), line=False)
    far = TRIANGULATION.replace("1 0 1  0 1 0", "1 0 1e1100  0 1 0")
    hostile_triangulation("element far away", far, (1, 3), line=False)
    hostile_triangulation("singular element", TRIANGULATION.replace("1 0 1  0 1 0", "0 0 0  0 0 0"), (1, 3), line=False)
    hostile_triangulation("element of 4,000 digits", TRIANGULATION.replace("1 0 1  0 1 0", f"{big} 0 1/{big}  0 1 0"), (1, 3), line=False)
    hostile_triangulation("a vertex twice in a cell", TRIANGULATION.replace("0 0  0 1  0 2", "0 0  0 0  0 1"), (1,), line=False)
    hostile_triangulation("one vertex thrice", TRIANGULATION.replace("0 0  0 1  0 2", "0 0  0 0  0 0"), (1,), line=False)
    hostile_triangulation("20,000 equal cells", TRIANGULATION.replace("cells 1", "cells 20001" + "\n0 0 0 1 0 2" * 20000), (1,), line=False)
    hostile_triangulation("elements that collide in a fixed hash", colliding_elements(30000), (1,), line=False)
    fan = "".join(f"\n1 0 {k} 0 1 {k * k}" for k in range(3000))
    cells = "".join(f"\n0 0 0 {k + 1} 0 {k + 2}" for k in range(2998))
    hostile_triangulation("3,000 cells at a vertex", f"flatdt-triangulation 1\nelements 3000{fan}\ncells 2998{cells}\n", (1,), line=False)


def crystals():
    """Small files that unpack, or add up, to large ones; a build without crystal import refuses all."""
    write("bomb.cif.gz", gzip.compress(b"data_x\nloop_\n_atom_site_label\n_atom_site_fract_x\n" + b"A 0 0 0\n" * 30_000_000, 1))
    run("gzip bomb", [FLATDT, "import", "bomb.cif.gz", "-o", "out"], [2, 3])
    cell = "".join(f"_cell_length_{a} 10\n" for a in "abc") + "".join(f"_cell_angle_{a} 90\n" for a in ("alpha", "beta", "gamma"))
    atoms = "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
    fractions = "+".join(f"1/{p}" for p in primes(20000, 2))
    write("sum.cif", f"data_x\n{cell}loop_\n_space_group_symop_operation_xyz\nx,y,z\n-x,y+{fractions},-z\n{atoms}A 0.1 0.2 0.3\n")
    run("operation with 20,000 fractions", [FLATDT, "import", "sum.cif", "-o", "out"], [2])
    rows = "".join(f"A{k} 0.1 0.2 0.3\n" for k in range(45000)) + "".join(f"B{k} 0.{k + 1:06d} 0.2 0.3\n" for k in range(40000))
    write("merge.cif", f"data_x\n{cell}loop_\n_space_group_symop_operation_xyz\nx,y,z\n-x,y+1/2,-z\n{atoms}{rows}")
    run("45,000 coincident sites", [FLATDT, "import", "merge.cif", "-o", "out", "--coincident", "merge"], [0, 2])
    for name in ("bomb.cif.gz", "sum.cif", "merge.cif", "out"):
        if os.path.exists(name):
            os.remove(name)


def streams():
    good = ["good.instance", "good.triangulation"]
    write("good.triangulation", TRIANGULATION)
    os.mkdir("folder")
    write("locked", INSTANCE)
    os.chmod("locked", 0)
    missing = ["absent", "folder", "folder/absent", "good.instance/x", "/dev/null", ""]
    if os.geteuid() != 0:
        missing.append("locked")
    for name in missing:
        run(f"check {name!r} instance", [CHECK, name, good[1]], [2])
        run(f"check {name!r} triangulation", [CHECK, good[0], name], [2])
        for command in ("info", "triangulate"):
            run(f"{command} {name!r}", [FLATDT, command, name], [2])
        run(f"draw {name!r}", [FLATDT, "draw", name, good[1], "-o", "out.svg"], [2])
    run("check - -", [CHECK, "-", "-"], [2], stdin=INSTANCE.encode())
    run("draw - -", [FLATDT, "draw", "-", "-", "-o", "out.svg"], [2], stdin=INSTANCE.encode())
    run("check, no file", [CHECK], [2])
    run("check, one file", [CHECK, good[0]], [2])
    run("check, three files", [CHECK, *good, good[0]], [2])
    run("check, unknown option", [CHECK, *good, "--fast"], [2])
    run("flatdt, no command", [FLATDT], [2])
    run("flatdt, unknown command", [FLATDT, "fly"], [2])
    run("generate 0", [FLATDT, "generate", "--manifold", "torus", "--points", "0"], [2])
    run("generate -1", [FLATDT, "generate", "--manifold", "torus", "--points", "-1"], [2])
    run("generate 10^18", [FLATDT, "generate", "--manifold", "torus", "--points", "1000000000000000000"], [2, 3])
    run("generate sphere", [FLATDT, "generate", "--manifold", "sphere", "--points", "1"], [2])
    run("generate family", [FLATDT, "generate", "--manifold", "torus", "--points", "1", "--family", "none"], [2])
    run("check standard input", [CHECK, "-", good[1]], [1], stdin=INSTANCE.encode())
    run("check empty standard input", [CHECK, "-", good[1]], [2], stdin=b"")
    run("triangulate standard input", [FLATDT, "triangulate", "-"], [0], stdin=INSTANCE.encode())
    run("triangulate cut standard input", [FLATDT, "triangulate", "-"], [2], stdin=INSTANCE[:-1].encode())
    for name, command in {
            "check": [CHECK, *good], "check json": [CHECK, *good, "--json"], "info": [FLATDT, "info", good[0]],
            "info json": [FLATDT, "info", good[0], "--json"], "triangulate": [FLATDT, "triangulate", good[0]],
            "manifolds": [FLATDT, "manifolds"], "help": [FLATDT, "--help"], "version": [FLATDT, "--version"],
            "help of a command": [FLATDT, "draw", "--help"], "help of the checker": [CHECK, "--help"],
            "generate": [FLATDT, "generate", "--manifold", "torus", "--points", "3", "--family", "uniform", "--seed", "1"]}.items():
        with open("/dev/full", "wb") as full:
            run(name + " > /dev/full", command, [3], stdout=full)
    for name, command in {"triangulate": ["triangulate", good[0]], "draw": ["draw", *good],
                          "generate": ["generate", "--manifold", "torus", "--points", "3", "--family", "uniform", "--seed", "1"]}.items():
        for target in ("folder", "folder/absent/out", "good.instance/out", ""):
            run(f"{name} -o {target!r}", [FLATDT, *command, "-o", target], [2, 3])
        if os.listdir("folder"):
            complain(name, f"left {os.listdir('folder')} in the folder")
    run("summary into an absent folder", [FLATDT, "triangulate", good[0], "-o", "folder/t", "--json-summary", "absent/s"], [2])
    run("triangulation and summary in one file", [FLATDT, "triangulate", good[0], "-o", "folder/t", "--json-summary", "folder/t"], [2])
    if os.listdir("folder"):
        complain("triangulate --json-summary", f"left {os.listdir('folder')} in the folder")
    run("triangulation and summary on standard output", [FLATDT, "triangulate", good[0], "--json-summary", "-"], [2])
    for seed in ("-1", "1e3", "99999999999999999999999", ""):
        run(f"seed {seed!r}", [FLATDT, "generate", "--manifold", "torus", "--points", "1", "--seed", seed], [2])
        run(f"order {seed!r}", [FLATDT, "triangulate", good[0], "--order", seed], [2])
    run("sheets of the wrong engine", [FLATDT, "triangulate", good[0], "--engine", "without-covers", "--max-sheets", "9"], [2])
    run("an output without a name", [FLATDT, "triangulate", good[0], "-o", ""], [2])
    # A reader that closes the pipe early must not make the writer crash.
    for command in ([FLATDT, "triangulate", good[0]], [FLATDT, "--help"], [CHECK, *good], [CHECK, *good, "--json"],
                    [CHECK, "--serve"], [CHECK, "--help"]):
        reading, writing = os.pipe()
        os.close(reading)
        run(f"{' '.join(command)} into a closed pipe", command, [3], stdin=b"{}\n", stdout=writing)
        os.close(writing)


KEEP = {"good.instance", "folder", "locked"}


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        write("good.instance", INSTANCE)
        for part in (truncated, bytes_, counts, numbers, sizes, crystals, streams):
            start = time.monotonic()
            part()
            print(f"{part.__name__}: {time.monotonic() - start:.0f} s", flush=True)
        os.chdir("/")
    print(f"{runs} runs, {len(complaints)} complaints; the slowest took {slowest[0]:.1f} s: {slowest[1]}")
    return 1 if complaints else 0


if __name__ == "__main__":
    CHECK, FLATDT = os.path.abspath(CHECK), os.path.abspath(FLATDT)
    sys.exit(main())
