#!/usr/bin/env python3
"""flatdt-check --serve, right and hostile requests: serve_test.py FLATDT-CHECK

Every request gets one reply, the replies are those of --json, and whatever comes between two right requests the second is
still answered. Standard library only.   Source: docs/serve.md.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import pathlib

CHECK = sys.argv[1]
complaints = []

INSTANCE = b"""flatdt-instance 1
dimension 2
manifold torus
points 9
0 0  1/3 0  2/3 0
0 1/3  1/3 1/3  2/3 1/3
0 2/3  1/3 2/3  2/3 2/3
"""


def grid(cells):
    lines = ["flatdt-triangulation 1", "elements 4", "1 0 0 0 1 0", "1 0 1 0 1 0", "1 0 0 0 1 1", "1 0 1 0 1 1",
             f"cells {cells}"]
    for y in range(3):
        for x in range(3):
            a, b, east, north = int(x == 2), int(y == 2), (x + 1) % 3, (y + 1) % 3
            lines.append(f"{x + 3 * y} 0 {east + 3 * y} {a} {east + 3 * north} {a + 2 * b}")
            lines.append(f"{x + 3 * y} 0 {x + 3 * north} {2 * b} {east + 3 * north} {a + 2 * b}")
    return ("\n".join(lines[:7 + cells]) + "\n").encode()


GOOD, WRONG = grid(18), grid(17)
LATE = b"flatdt-triangulation 1\nelements 0\ncells 1\n0 0 0 0 0 0\n"  # malformed in its line 4


def request(name, instance=INSTANCE, triangulation=GOOD):
    return b"check %s %d %d\n%s%s\n" % (name.encode(), len(instance), len(triangulation), instance, triangulation)


def expect(holds, what):
    if not holds:
        complaints.append(what)
        print("FAILED:", what)


def serve(data, code=0, options=()):
    """The replies to these bytes."""
    done = subprocess.run([CHECK, "--serve", *options], input=data, capture_output=True, timeout=300)
    expect(done.returncode == code, f"exit {done.returncode}, not {code}, after {data[:60]!r}: {done.stderr[:300]!r}")
    try:
        return [json.loads(line) for line in done.stdout.decode("ascii").splitlines()]
    except ValueError as error:
        expect(False, f"no JSON lines after {data[:60]!r}: {error}")
        return []


def short(reply):
    """What matters of a reply: its id, and the verdict or "error"."""
    expect(reply["schema"] == ("flatdt-serve 1" if "error" in reply else "flatdt-check 1"), f"schema of {reply}")
    return reply["id"], "error" if "error" in reply else reply["verdict"]


def answers(data, wanted, code=0, options=()):
    replies = serve(data, code, options)
    found = [short(reply) for reply in replies]
    expect(found == wanted, f"{found}, not {wanted}, after {data[:60]!r}")
    return replies


def same_as_json(folder):
    for name, triangulation in (("good", GOOD), ("wrong", WRONG), ("malformed", LATE)):
        (folder / "i").write_bytes(INSTANCE)
        (folder / "t").write_bytes(triangulation)
        whole = subprocess.run([CHECK, "--json", folder / "i", folder / "t"], capture_output=True, check=False).stdout
        [reply] = serve(request(name, INSTANCE, triangulation))
        expect(reply.pop("id") == name, "the id")
        reason = reply.pop("reason", "")
        expect(json.dumps(reply) == json.dumps(json.loads(whole)), f"{name}: not the object of --json")
        expect((reason != "") == (name == "malformed"), f"{name}: reason {reason!r}")
    [reply] = serve(request("late", INSTANCE, LATE))
    expect(reply["reason"].startswith("triangulation:4: "), "the line in the reason")
    [reply] = serve(request("x", b"#\nflatdt-instance 2\n", GOOD))
    expect(reply["reason"].startswith("instance:2: "), "the line in the reason for an instance")


def right_requests():
    answers(b"", [])
    answers(b"\n\n" + request("a") + b"\n" + request("b!\"\\", INSTANCE, WRONG), [("a", "VERIFIED"), ("b!\"\\", "REFUTED")])
    answers(b"check e 0 0\n\n" + request("a"), [("e", "MALFORMED"), ("a", "VERIFIED")])
    answers(request("r") * 50, [("r", "VERIFIED")] * 50)
    # The texts may hold anything: they are counted, not searched.
    tricky = INSTANCE + b"# check x 1 1\n#\ncheck y 1 1\n\x00\xff"
    answers(request("t", tricky) + request("a"), [("t", "MALFORMED"), ("a", "VERIFIED")])


def one_at_a_time():
    """A client that waits for each reply before it goes on."""
    with subprocess.Popen([CHECK, "--serve"], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as service:
        for k in range(5):
            service.stdin.write(request(str(k), INSTANCE, WRONG if k % 2 else GOOD))
            service.stdin.flush()
            expect(short(json.loads(service.stdout.readline())) == (str(k), "REFUTED" if k % 2 else "VERIFIED"), f"turn {k}")
        service.stdin.write(b"nonsense\n")
        service.stdin.flush()
        expect("error" in json.loads(service.stdout.readline()), "an error reply at once")
        service.stdin.close()
        expect(service.wait(60) == 0, "the end of the input")


def hostile_requests():
    """One error reply, and then the next request is answered."""
    for line in (b"hello", b"check", b"check ", b"check a", b"check a 1", b"check a 1 2 3", b"check a -1 5", b"check a 5 1e3",
                 b"check a 0x10 1", b"check a  1 1", b"check a 1 1 ", b"check a\t1 1", b"check a 1 1\r", b"CHECK a 1 1",
                 b"check a 9999999999999999 1", b"check a 18446744073709551616 1", b"check " + b"i" * 101 + b" 1 1",
                 b"check \xc3\xa9 1 1", b"check " + b"9" * 100000, b"\x00" * 1000, b"{\"instance\":\"...\"}", b"x" * 3000000):
        replies = serve(line + b"\n" + request("next"))
        expect([short(r)[1] for r in replies] == ["error", "VERIFIED"], f"{line[:40]!r}: {[short(r) for r in replies]}")
        # The texts after a malformed header are skipped with it.
        replies = serve(line + b"\n" + INSTANCE + GOOD + b"\n" + request("next"))
        expect([short(r)[1] for r in replies] == ["error", "VERIFIED"], f"{line[:40]!r} with texts: {replies}")
    # Sizes that are wrong: too small, the rest is skipped; too large, the next request is a part of the texts.
    answers(b"check s %d %d\n" % (len(INSTANCE), len(GOOD) - 5) + INSTANCE + GOOD + b"\n" + request("next"),
            [("s", "error"), ("next", "VERIFIED")])
    answers(b"check l %d %d\n" % (len(INSTANCE), len(GOOD) + 5) + INSTANCE + GOOD + b"\n" + request("lost") + request("next"),
            [("l", "error"), ("next", "VERIFIED")])


def cut_short():
    for size in (1, 20, len(INSTANCE), len(INSTANCE) + len(GOOD)):
        whole = request("cut")
        data = whole[:whole.index(b"\n") + 1 + size]
        answers(request("a") + data, [("a", "VERIFIED"), ("cut", "error")], code=2)
    answers(b"check a 1 1", [("a", "error")], code=2)
    answers(b"check a 1", [("a", "error")], code=2)
    # What is announced takes no memory.
    answers(b"check huge 100000000 100000000\nabc", [("huge", "error")], code=2)
    answers(b"check huger 999999999999999 0\nabc", [("huger", "error")], code=2)


def limits():
    size = len(INSTANCE) + len(GOOD)
    answers(request("fits") + request("a"), [("fits", "VERIFIED"), ("a", "VERIFIED")], options=("--max-bytes", str(size)))
    small = ("--max-bytes", str(size - 1))
    replies = answers(request("big") + request("w", INSTANCE, WRONG), [("big", "error"), ("w", "REFUTED")], options=small)
    expect(str(size - 1) in replies[0]["error"], "the limit is named")
    # A check that cannot end in a second: many points, of which each is a new orbit with a long denominator.
    source = random.Random(5)
    numbers = [f"{source.getrandbits(6600)}/{source.getrandbits(6600) | 1}" for _ in range(400)]
    slow = ("flatdt-instance 1\ndimension 2\nmanifold torus\npoints 200\n" + "\n".join(numbers) + "\n").encode()
    cells = "".join(f"{source.randrange(200)} 0 {source.randrange(200)} 1 {source.randrange(200)} 2\n" for _ in range(60000))
    slow_cells = (GOOD.split(b"cells")[0].decode() + "cells 60000\n" + cells).encode()
    data = request("slow", slow, slow_cells)
    replies = answers(data + request("never"), [("slow", "UNKNOWN")], code=3, options=("--max-seconds", "1"))
    expect("1 s of processor time" in replies[0]["reason"], "the reason")
    for options in (["--max-bytes", "-1"], ["--max-bytes", "x"], ["--max-seconds", "99999999999"], ["i", "t"], ["-", "t"]):
        done = subprocess.run([CHECK, "--serve", *options], input=b"", capture_output=True, check=False)
        expect(done.returncode == 2 and done.stderr.startswith(b"flatdt-check: ") and done.stdout == b"", f"options {options}")
    for options in (["--max-bytes", "5", "i", "t"], ["--max-seconds", "5", "i", "t"], []):
        done = subprocess.run([CHECK, *options], input=b"", capture_output=True, check=False)
        expect(done.returncode == 2 and b"Run with --help" in done.stderr, f"options {options} without --serve")


def random_bytes():
    """Noise between right requests: no crash, JSON lines throughout, and the last request is answered."""
    source = random.Random(1)
    pieces = [b"check ", b"check a 3 2\n", b"\n", b" ", b"12", b"-", b"a", b"\x00", b"\xff", b"check z 0 0\n\n", INSTANCE[:40]]
    for _ in range(40):
        noise = b"".join(source.choice(pieces) for _ in range(source.randrange(1, 30)))
        last = b"\n" * 20 + request("last")
        done = subprocess.run([CHECK, "--serve"], input=noise + last, capture_output=True, timeout=300, check=False)
        replies = [json.loads(line) for line in done.stdout.decode("ascii").splitlines()]
        expect(done.returncode == 0 and short(replies[-1]) == ("last", "VERIFIED"), f"after {noise!r}: {done}")


def failed_write():
    with open("/dev/full", "wb") as full:
        done = subprocess.run([CHECK, "--serve"], input=request("a"), stdout=full, stderr=subprocess.DEVNULL, check=False)
    expect(done.returncode == 3, f"a reply that cannot be written: exit {done.returncode}")


def wrong_usage():
    done = subprocess.run([CHECK, "--serve", "--jobs", "2"], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    expect(done.returncode == 2 and b"no --jobs" in done.stderr and not done.stdout, f"--serve with --jobs: {done}")


def failed_read():
    folder = os.open("/", os.O_RDONLY)
    done = subprocess.run([CHECK, "--serve"], stdin=folder, capture_output=True, check=False)
    os.close(folder)
    expect(done.returncode == 2 and b"cannot read standard input" in done.stderr, f"an input that cannot be read: {done}")


with tempfile.TemporaryDirectory() as name:
    same_as_json(pathlib.Path(name))
right_requests()
one_at_a_time()
hostile_requests()
cut_short()
limits()
random_bytes()
failed_write()
failed_read()
wrong_usage()
print("all passed" if not complaints else f"{len(complaints)} complaints")
sys.exit(bool(complaints))
