"""corpora/invalid/malformed: files that break the grammar or a limit of FORMAT.md, each by one edit of a good pair."""

import os

INSTANCE = """flatdt-instance 1
dimension 2
manifold torus
generators 2
  1 0 1  0 1 0
  1 0 0  0 1 1
metric 1 0 1
points 2
  0 0
  1/3 2/7
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
  0 0  0 1  1 2
"""


def numbers():
    for name, word in {
            "zero-denominator": "1/0", "zero-denominator-many": "0/000", "sign-in-denominator": "1/-2", "two-signs": "+-1",
            "sign-alone": "-", "dot-alone": ".", "no-mantissa": "e5", "no-exponent": "1e", "exponent-fraction": "1e1.5",
            "exponent-two-signs": "1e+-1", "hex-without-digits": "0x", "hex-dot-alone": "0x.", "hex-no-exponent": "0x1p",
            "hex-fraction": "0x1/2", "hex-e-sign": "0x1e+1", "decimal-over": "1.5/2", "over-decimal": "1/2.5", "over-exponent": "1/2e3",
            "binary-exponent-without-0x": "1p3", "no-numerator": "/2", "no-denominator": "1/", "two-slashes": "1/2/3",
            "underscore": "1_000", "comma": "1,5", "infinity": "inf", "nan": "nan", "octal": "0o7", "letter": "1a", "suffix": "1.0f",
            "two-dots": "1.2.3", "exponent-over-limit": "1e1101", "exponent-under-limit": "1e-1101", "exponent-huge": "1e999999999",
            "exponent-beyond-words": "1e" + "9" * 40, "zero-with-huge-exponent": "0e1101", "hex-exponent-over-limit": "0x1p4401",
            "hex-exponent-under-limit": "0x1p-4401", "token-too-long": "1" + "0" * 4096, "token-too-long-zeros": "0" * 4097}.items():
        yield "number-" + name, word


def edits():
    """(name, which file, its bytes)."""
    def i(old, new, count=1):
        assert INSTANCE.count(old) >= 1, old
        return "instance", INSTANCE.replace(old, new, count).encode("latin-1")

    def t(old, new, count=1):
        assert TRIANGULATION.count(old) >= 1, old
        return "triangulation", TRIANGULATION.replace(old, new, count).encode("latin-1")

    for name, word in numbers():
        yield name, *i("1/3", word)
    yield "instance-empty", "instance", b""
    yield "instance-blank", "instance", b" \n\t\n# nothing\n"
    yield "instance-bom", "instance", b"\xef\xbb\xbf" + INSTANCE.encode()
    yield "instance-nul", *i("1/3 2/7", "1/3\0 2/7")
    yield "instance-utf8", *i("1/3", "1/3\xc2\xa0")
    yield "instance-del", *i("1/3", "1/3\x7f")
    yield "instance-control", *i("1/3", "1/3\x1b")
    yield "instance-header-2", *i("instance 1", "instance 2")
    yield "instance-header-case", *i("flatdt-instance", "Flatdt-Instance")
    yield "instance-header-word", *i("instance 1", "instance 1.0")
    yield "instance-is-triangulation", "instance", TRIANGULATION.encode()
    yield "dimension-missing", *i("dimension 2\n", "")
    yield "dimension-1", *i("dimension 2", "dimension 1")
    yield "dimension-4", *i("dimension 2", "dimension 4")
    yield "dimension-3-of-torus", "instance", b"flatdt-instance 1\ndimension 3\nmanifold torus\npoints 1\n0 0 0\n"
    yield "dimension-2-of-dicosm", "instance", b"flatdt-instance 1\ndimension 2\nmanifold P21\npoints 1\n0 0\n"
    yield "neither-name-nor-generators", "instance", b"flatdt-instance 1\ndimension 2\nmetric 1 0 1\npoints 1\n0 0\n"
    yield "name-unknown", *i("manifold torus", "manifold sphere")
    yield "name-case", *i("manifold torus", "manifold Torus")
    yield "name-hermann-mauguin", "instance", b"flatdt-instance 1\ndimension 3\nmanifold P2_1\npoints 1\n0 0 0\n"
    yield "name-missing", *i("manifold torus", "manifold")
    yield "generators-0", *i("generators 2\n  1 0 1  0 1 0\n  1 0 0  0 1 1\n", "generators 0\n")
    yield "generators-too-few", *i("generators 2", "generators 3")
    yield "generators-too-many", *i("generators 2", "generators 1")
    yield "generators-over-limit", *i("generators 2", "generators 10001")
    yield "generators-huge", *i("generators 2", "generators 1000000000000000000")
    yield "metric-short", *i("metric 1 0 1", "metric 1 0")
    yield "metric-full-matrix", *i("metric 1 0 1", "metric 1 0 0 1")
    yield "metric-twice", *i("metric 1 0 1", "metric 1 0 1 metric 1 0 1")
    yield "metric-before-generators", *i("manifold torus", "manifold torus metric 1 0 1")
    yield "metric-zero", *i("metric 1 0 1", "metric 0 0 0")
    yield "metric-negative", *i("metric 1 0 1", "metric -1 0 -1")
    yield "metric-indefinite", *i("metric 1 0 1", "metric 1 2 1")
    yield "metric-semidefinite", *i("metric 1 0 1", "metric 1 1 1")
    yield "metric-semidefinite-3d", "instance", b"flatdt-instance 1\ndimension 3\nmanifold P1\nmetric 1 0 0 1 1 1\npoints 1\n0 0 0\n"
    yield "sections-swapped", *i("dimension 2\nmanifold torus", "manifold torus\ndimension 2")
    yield "keyword-case", *i("points", "Points")
    yield "points-missing", "instance", INSTANCE[:INSTANCE.index("points")].encode()
    yield "points-0", *i("points 2\n  0 0\n  1/3 2/7", "points 0")
    yield "points-too-few", *i("points 2", "points 3")
    yield "points-too-many", *i("points 2", "points 1")
    yield "points-odd", *i("1/3 2/7", "1/3")
    yield "points-over-limit", *i("points 2", "points 100000001")
    yield "points-huge", *i("points 2", "points 1000000000000000000")
    yield "points-beyond-words", *i("points 2", "points " + "9" * 50)
    for name, word in (("plus", "+2"), ("minus", "-2"), ("decimal", "2.0"), ("hex", "0x2"), ("rational", "4/2"), ("exponent", "2e0")):
        yield "count-" + name, *i("points 2", "points " + word)
    yield "instance-goes-on", "instance", INSTANCE.encode() + b"end\n"
    yield "instance-cut-short", "instance", INSTANCE[:-1].encode()
    yield "instance-cut-in-token", "instance", INSTANCE[:-3].encode()
    yield "triangulation-empty", "triangulation", b""
    yield "triangulation-bom", "triangulation", b"\xef\xbb\xbf" + TRIANGULATION.encode()
    yield "triangulation-nul", *t("cells 1", "cells 1 \0")
    yield "triangulation-binary", "triangulation", bytes((k * k * 7 + k) % 256 for k in range(500))
    yield "triangulation-header-2", *t("triangulation 1", "triangulation 2")
    yield "triangulation-is-instance", "triangulation", INSTANCE.encode()
    yield "subgroup-twice", *t("elements 3", "subgroup 0 elements 3")
    yield "subgroup-after-elements", "triangulation", b"flatdt-triangulation 1 elements 1 1 0 0 0 1 0 subgroup 0 cells 0\n"
    yield "subgroup-short", *t("subgroup 2", "subgroup 3")
    yield "subgroup-over-limit", *t("subgroup 2", "subgroup 10001")
    yield "elements-missing", "triangulation", b"flatdt-triangulation 1 cells 0\n"
    yield "elements-over-limit", *t("elements 3", "elements 100000001")
    yield "elements-huge", *t("elements 3", "elements 1000000000000000000")
    yield "elements-0-with-cells", "triangulation", b"flatdt-triangulation 1 elements 0 cells 1 0 0 0 0 0 0\n"
    yield "elements-short", *t("1 0 1  0 1 0", "1 0 1  0 1")
    yield "elements-zero-denominator", *t("1 0 1  0 1 0", "1 0 1/0  0 1 0")
    yield "cells-missing", "triangulation", TRIANGULATION[:TRIANGULATION.index("cells")].encode()
    yield "cells-over-limit", *t("cells 1", "cells 1000000001")
    yield "cells-huge", *t("cells 1", "cells 1000000000000000000")
    yield "cells-too-few", *t("cells 1", "cells 2")
    yield "cells-too-many", *t("cells 1", "cells 0")
    yield "cell-short", *t("0 1  1 2", "0 1  1")
    yield "index-point", *t("1 2\n", "2 2\n")
    yield "index-element", *t("1 2\n", "1 3\n")
    yield "index-negative", *t("1 2\n", "1 -1\n")
    yield "index-plus", *t("1 2\n", "1 +2\n")
    yield "index-number", *t("1 2\n", "1 2.0\n")
    yield "index-huge", *t("1 2\n", "1 18446744073709551618\n")
    yield "index-wraps-32", *t("1 2\n", "1 4294967298\n")
    yield "triangulation-goes-on", "triangulation", TRIANGULATION.encode() + b"0\n"
    yield "triangulation-cut-short", "triangulation", TRIANGULATION[:-1].encode()


def make(folder, record):
    from judge import CONDITIONS
    os.makedirs(folder, exist_ok=True)
    names = set()
    for name, which, data in edits():
        assert name not in names, name
        names.add(name)
        files = {"instance": INSTANCE.encode(), "triangulation": TRIANGULATION.encode(), which: data}
        for kind, text in files.items():
            with open(f"{folder}/{name}.{kind}", "wb") as out:
                out.write(text)
        record(f"{folder}/{name}", "", "MALFORMED", 2, {c: "skipped" for c in CONDITIONS}, [f"error {which}"])
