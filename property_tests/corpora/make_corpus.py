#!/usr/bin/env python3
"""Makes corpora/valid and corpora/invalid: make_corpus.py [--engine FLATDT] [NAME...]

Every file is built by hand-written geometry below, or by an edit of a file in corpora/valid. With --engine the files of
corpora/valid that come from our own engine are made anew as well (else they are read as they are). `fails` is what the
author derives from FORMAT.md for that file; judge.py computes all statuses by definition; a record is written only if both
agree. Neither flatdt-check nor its source is consulted. Deterministic.
"""

import argparse
import os
import random
import subprocess
import sys

sys.dont_write_bytecode = True

from build import Drawing, cover, five, flips, grid, kronecker, kuhn, lift, multiples, shuffled
from flatgeom import (CATALOGUE, F, Instance, T3, Triangulation, apply, compose, element, identity, inverse, manifold,
                      read_instance, read_triangulation, translation)
from judge import CONDITIONS, Judge
from large_numbers import apart, coprime, far, with_points

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "corpora")
LOOP = "simplices.injective skeleton.no-loop skeleton.no-2-cycle complex.intersection"
CYCLE = "skeleton.no-2-cycle complex.intersection"
entries, only, engine = {}, [], None


def entry(folder, fails=""):
    """Registers a function () -> (instance, triangulation); its docstring says what is wrong."""
    def register(make):
        name = f"{folder}/{make.__name__.lstrip('_').replace('_', '-')}"
        assert name not in entries, name
        entries[name] = make, fails.split()
        return make
    return register


def write(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, "w", newline="", encoding="latin-1") as out:
        out.write(text)


def record(path, note, verdict, code, status, more=()):
    lines = [f"# {line}" for line in note.splitlines() if line.strip()]
    lines += [f"verdict {verdict}", f"exit {code}"] + [f"{name} {status[name]}" for name in CONDITIONS] + list(more)
    write(path + ".expected", "\n".join(lines) + "\n")


def emit(name, make, fails):
    instance, tri = make()
    note = " ".join((make.__doc__ or "").split())
    judge = Judge(instance, tri)
    found = [n for n in CONDITIONS if judge.status[n] == "fails"]
    if sorted(found) != sorted(fails):
        print(f"DIFFER {name}\n  by hand: {' '.join(fails)}\n  judge:   {' '.join(found)}")
        return False
    verdict, code = judge.verdict()
    path = os.path.join(ROOT, name)
    if not getattr(make, "engine", False):
        write(path + ".instance", instance.text())
        write(path + ".triangulation", tri.text())
    record(path, note, verdict, code, judge.status)
    print(f"{name}: {verdict} {' '.join(found)} ({len(tri.cells)} cells)", flush=True)
    return True


# ================================================================ engine's own files, the base of many edits


def engine_file(name, instance, expect_cover):
    def make():
        path = os.path.join(ROOT, "valid", name)
        if engine:
            write(path + ".instance", instance.text())
            subprocess.run([engine, "triangulate", path + ".instance", "-o", path + ".triangulation"], check=True,
                           stderr=subprocess.DEVNULL)
        if not os.path.exists(path + ".triangulation"):
            sys.exit(f"{path}.triangulation is missing: run with --engine FLATDT")
        tri = read_triangulation(path + ".triangulation", instance.dim)
        assert (tri.subgroup is not None) == expect_cover, name
        return read_instance(path + ".instance"), tri
    make.__name__, make.engine = name, True
    make.__doc__ = "Computed by flatdt: " + ("a covering space." if expect_cover else "the manifold itself.")
    entries["valid/" + name] = make, []
    return make


ONE = {}
for _names, _dim, *_ in CATALOGUE:
    _name = _names.split()[0]
    ONE[_name] = engine_file(f"{_name}-1", Instance(_dim, kronecker(_dim, 3)[2:], _name), True)
TORUS = engine_file("torus-24", Instance(2, kronecker(2, 24), "torus"), False)
KLEIN = engine_file("klein-bottle-24", Instance(2, kronecker(2, 24), "klein-bottle", metric="1 0 4"), False)
T3_40 = engine_file("torocosm-40", Instance(3, kronecker(3, 40), "torocosm"), False)
G2_50 = engine_file("dicosm-50", Instance(3, kronecker(3, 50), "P21", metric="1 0 0 1 0 4"), False)
B2_45 = engine_file("second-amphicosm-45", Instance(3, kronecker(3, 45), "Cc", metric="1 0 0 1 0 4"), False)
B3_45 = engine_file("first-amphidicosm-45", Instance(3, kronecker(3, 45), "Pca21", metric="4 0 0 1 0 4"), False)
G4_45 = engine_file("tetracosm-45", Instance(3, kronecker(3, 45), "P43", metric="1 0 0 1 0 16"), False)
P32_2 = engine_file("tricosm-mirror-1", Instance(3, kronecker(3, 3)[2:], "P32"), True)

# ================================================================ hand-made: the square and cubic lattice


def torus(points=("0 0",), metric=None, **kw):
    return Instance(2, points, "torus", metric=metric, **kw)


def torus3(points=("0 0 0",), metric=None, **kw):
    return Instance(3, points, "torocosm", metric=metric, **kw)


def kuhn_tri(instance, sizes, subgroup=True, without=(), mirror=lambda c: (), scale=1):
    sheet = Drawing(instance, multiples(*(s * scale for s in sizes)) if subgroup else None)
    for corner in grid(*sizes):
        if corner not in without:
            for cell in kuhn(corner, mirror(corner)):
                sheet.add([tuple(F(v) * scale for v in x) for x in cell])
    return sheet


@entry("valid")
def hand_kuhn_2d():
    """Two triangles per unit square, modulo (3Z)^2; not from our engine."""
    return torus(), kuhn_tri(torus(), (3, 3)).tri


@entry("valid")
def hand_mixed_diagonals_2d():
    """Unit squares cut along diagonals chosen at random: every choice is weakly Delaunay."""
    rng = random.Random(7)
    choice = {c: ((0,) if rng.random() < 0.5 else ()) for c in grid(4, 3)}
    return torus(), kuhn_tri(torus(), (4, 3), mirror=choice.get).tri


@entry("valid")
def hand_kuhn_3d():
    """The Kuhn triangulation of Z^3 modulo (3Z)^3: 27 vertices, 162 cells; not from our engine."""
    return torus3(), kuhn_tri(torus3(), (3, 3, 3)).tri


@entry("valid")
def hand_mixed_layers_3d():
    """Kuhn triangulations mirrored in z in every second layer, modulo <3, 4, 4> with metric one: other diagonals."""
    return torus3(), kuhn_tri(torus3(), (3, 3, 4), mirror=lambda c: (2,) * (c[2] % 2)).tri


@entry("valid")
def hand_checkerboard_3d():
    """Five tetrahedra per cube, alternating, modulo (4Z)^3, which the alternation respects."""
    sheet = Drawing(torus3(), multiples(4, 4, 4))
    for corner in grid(4, 4, 4):
        sheet.add(*five(corner, 0))
    return sheet.instance, sheet.tri


@entry("valid")
def sheared_subgroup_2d():
    """The covering torus <(4,0), (1,3)>: not aligned with the axes, index 12."""
    sheet = kuhn_tri(torus(), (4, 3))
    sheet.tri.subgroup = ["1 0 4 0 1 0", "1 0 1 0 1 3"]
    return torus(), sheet.tri


@entry("valid")
def redundant_subgroup_2d():
    """(3Z)^2 by six generators, one the identity, one of them a sum of others."""
    sheet = kuhn_tri(torus(), (3, 3))
    sheet.tri.subgroup = ["1 0 0 0 1 0", "1 0 6 0 1 0", "1 0 9 0 1 0", "1 0 3 0 1 3", "1 0 -3 0 1 6", "1 0 6 0 1 6"]
    return torus(), sheet.tri


def klein_grid(subgroup, columns, rows, seed=5):
    instance = Instance(2, ["0 0"], "klein-bottle", metric="1 0 4")
    rng = random.Random(seed)
    sheet = Drawing(instance, subgroup)
    for x, y in grid(columns, rows):
        for cell in kuhn((x, y), (0,) * rng.randrange(2)):
            sheet.add([(a, F(b, 2)) for a, b in cell])
    return instance, sheet.tri


@entry("valid")
def hand_klein_grid_not_normal():
    """A Klein bottle of 5 x 3 squares: H = <(5,0), glide^3> is no normal subgroup of the Klein bottle group."""
    return klein_grid(["1 0 5 0 1 0", "-1 0 0 0 1 3/2"], 5, 3)


@entry("valid")
def checkerboard_good_diagonals_2d():
    """Eight points of a checkerboard in the torus, Delta = delta/2: with these diagonals a simplicial complex."""
    return checkerboard(lambda i, j: (i + (j % 2) + j // 2 * 2) % 4 in (1, 2))


def checkerboard(horizontal):
    points = [(F(i, 4), F(j, 4)) for i, j in grid(4, 4) if (i + j) % 2 == 0]
    sheet = Drawing(torus(points))
    for i, j in grid(4, 4):
        if (i + j) % 2 == 1:
            w, e, s, n = (((i + a) / F(4), (j + b) / F(4)) for a, b in ((-1, 0), (1, 0), (0, -1), (0, 1)))
            sheet.add(*(([w, e, n], [w, e, s]) if horizontal(i, j) else ([w, s, n], [e, s, n])))
    return sheet.instance, sheet.tri


def moved_grid(up):
    points = [(F(i, 4), F(j, 4)) for i, j in grid(4, 4)]
    points[5] = (points[5][0] + F(1, 2 ** 60), points[5][1] + F(1, 2 ** 60))
    instance = torus(points)
    place = {(i, j): points[(i % 4) * 4 + j % 4] for i, j in grid(4, 4)}

    def at(x):
        p = place[x[0] % 4, x[1] % 4]
        return p[0] + x[0] // 4, p[1] + x[1] // 4

    sheet = Drawing(instance)
    # Only the square at (1,1)-(2,2) and that at (0,0)-(1,1) have their diagonal through the moved point; the moved
    # point leaves the circle of the latter's other three corners, and enters the circle of the former's.
    for c in grid(4, 4):
        mirror = {(0, 0): (0,), (1, 1): (), (1, 0): up, (0, 1): up}.get(c, ())
        for cell in kuhn(c, mirror):
            sheet.add([at(x) for x in cell])
    return instance, sheet.tri


@entry("valid")
def edits_2d():
    """torus-24 with other lifts, vertices and cells in another order, elements repeated and unused."""
    i, t = TORUS()
    return i, shuffled(i, t, 1)


@entry("valid")
def edits_klein():
    """klein-bottle-24, edited in the same way: lifts by orientation-reversing elements too."""
    i, t = KLEIN()
    return i, shuffled(i, t, 2)


@entry("valid")
def edits_3d():
    """tetracosm-45 (mirror image), edited in the same way."""
    i, t = G4_45()
    return i, shuffled(i, t, 3)


@entry("valid")
def edits_cover_3d():
    """The cover of first-amphicosm-1, edited in the same way: lifts by the subgroup only."""
    i, t = ONE["first-amphicosm"]()
    return i, shuffled(i, t, 4)


def duplicated(instance, tri, seed):
    """Appends a second name for every third point, in another place of its orbit, and uses either."""
    rng = random.Random(seed)
    steps = list(instance.group().reps.values())
    points, other = list(instance.points), {}
    for i in range(0, len(points), 3):
        g = compose(rng.choice(steps), translation(*(rng.randrange(-2, 3) for _ in range(instance.dim))))
        other[i] = len(points), inverse(g)
        points.append(apply(g, points[i]))
    pick = lambda i, g: (other[i][0], compose(g, other[i][1])) if i in other and rng.random() < 0.5 else (i, g)
    cells = [[pick(i, g) for i, g in cell] for cell in tri.cells]
    return (Instance(instance.dim, points, instance.manifold, instance.generators, instance.metric),
            Triangulation(cells, tri.subgroup))


@entry("valid")
def duplicate_points_klein():
    """Points given twice, the second time elsewhere in the orbit; the cells use the later index too."""
    return duplicated(*KLEIN(), 1)


@entry("valid")
def duplicate_points_3d():
    """The same in the second amphicosm."""
    return duplicated(*B2_45(), 2)


@entry("valid")
def covers_of_covers_klein():
    """klein-bottle-24, which needs no cover, in the torus <(1,0), (0,1)> that covers it twice."""
    i, t = KLEIN()
    return i, cover(i, t, multiples(1, 1))


@entry("valid")
def not_normal_klein():
    """One generic point of the Klein bottle modulo <(5,0), glide^7>, index 35, orientation-reversing, not normal."""
    i, t = ONE["klein-bottle"]()
    return i, cover(i, t, ["1 0 5 0 1 0", "-1 0 0 0 1 7/2"])


@entry("valid")
def dicosm_covers_didicosm():
    """One generic point of the didicosm modulo a dicosm subgroup: <5, 3, 3> and a screw to the fifth."""
    i, t = ONE["didicosm"]()
    return i, cover(i, t, multiples(5, 3, 3) + ["1 0 0 5/2 0 -1 0 1/2 0 0 -1 0"])


@entry("valid")
def not_normal_tetracosm():
    """One generic point of the tetracosm modulo a tetracosm subgroup of index 45 that is not normal: <3Z^2, screw^5>."""
    i, t = ONE["tetracosm"]()
    return i, cover(i, t, multiples(3, 3, 5)[:2] + ["0 -1 0 0 1 0 0 0 0 0 1 5/4"])


@entry("valid")
def handedness_is_no_claim():
    """Generators of P3_2 under the name P31: a name claims the manifold, not the handedness."""
    i, t = P32_2()
    return Instance(3, i.points, "P31", manifold("P32")[2], i.metric or manifold("P32")[3]), t


@entry("valid")
def affine_basis_no_name():
    """A torus by three generators of a sheared basis, rational and redundant; no name, so group.name is skipped."""
    i, t = TORUS()
    change = lambda x: (2 * x[0] + F(1, 3) * x[1] + 5, F(1, 2) * x[1] - F(7, 5))
    linear = lambda v: (2 * v[0] + F(1, 3) * v[1], F(1, 2) * v[1])
    # |x|^2 in the new basis: the old coordinates are ((u - 2w/3)/2, 2w).
    j = Instance(2, [change(p) for p in i.points], None, ["1 0 2 0 1 0", "1 0 13/3 0 1 1/2", "1 0 0 0 1 0", "1 0 -19/3 0 1 -1/2"],
                 "1/4 -1/6 37/9")
    cells = [[(k, translation(*linear(g[1]))) for k, g in cell] for cell in t.cells]
    return j, Triangulation(cells)


@entry("valid")
def lexical():
    """Every form of a number, all six kinds of white space, comments with any bytes, a token of 4,096 bytes, exponents at their
    limits, leading zeros in counts. Otherwise hand-kuhn-2d with its point moved."""
    instance = torus([(F(2 ** 4400 - 3, 2 ** 4404), F(7, 10 ** 1100))])
    instance.text = lambda: (
        "# any bytes: \xe9 \x01 \x00\nflatdt-instance#a comment ends a token\n1 dimension\r2\r\nmanifold\x0bp1\x0cgenerators 3\n"
        "+1. -0 0x1p0 0e1100 1E0 .0  01/1 0/7 0X0.P-4400 0.000 1e+0 2/2  1 0 0 -0/5 1 -0x3.0p+0\n"
        "metric 0X10p-4 0e-1100 10e-1\tpoints 1 0x." + hex(2 ** 4400 - 3)[2:].upper() + "p-4 " + "0" * 4089 + "7e-1100#end")
    tri = hand_kuhn_2d()[1]
    body = tri.text().split("elements 16", 1)[1]
    tri.text = lambda: ("flatdt-triangulation\n1\nsubgroup 2 1 0 3. 0 1 0x0 1 0 0. 0 +1 30e-1\nelements 0016" + body.rstrip() +
                        " # no line break at the end")
    return instance, tri


# ================================================================ group.*


def inadmissible(folder, name, note, dim, generators=None, metric=None, claim=None):
    def make():
        instance = Instance(dim, ["1/7 2/9" + " 3/11" * (dim - 2)], claim, generators, metric)
        return instance, Triangulation([[(0, translation(*x)) for x in c] for c in kuhn((0,) * dim)])
    make.__name__, make.__doc__ = name, note
    entries[f"{folder}/{name}"] = make, [folder]


C, T, N = "group.crystallographic", "group.torsion-free", "group.name"
X, Y = "1 0 1 0 1 0", "1 0 0 0 1 1"
A3, B3_, C3 = T3
for _name, _note, *_rest in [
    ("2d-one-translation", "Not cocompact: one translation.", 2, [X]),
    ("2d-identity", "Not cocompact: the trivial group.", 2, ["1 0 0 0 1 0"]),
    ("2d-rotation-only", "Finite, so not cocompact; it has fixed points too, but that is judged later.", 2, ["0 -1 0 1 0 0"]),
    ("2d-parallel-translations", "Not cocompact: commensurable translations of one direction.", 2, [X, "1 0 2/3 0 1 0", "1 0 -5/7 0 1 0"]),
    ("2d-one-axis-glides", "Not cocompact: two glides along one axis.", 2, ["-1 0 0 0 1 1/2", "-1 0 0 0 1 1/3"]),
    ("2d-rotation-3-4-5", "An isometry of the metric of infinite order: a 13th linear part, not discrete.", 2, [X, Y, "3/5 -4/5 0 4/5 3/5 0"]),
    ("2d-two-reflections-3-4-5", "Two glides whose product has infinite order.", 2, ["1 0 1 0 -1 0", "7/25 24/25 0 24/25 -7/25 1", X]),
    ("2d-metric-not-invariant", "The glide does not preserve this metric.", 2, None, "1 1/3 1", "klein-bottle"),
    ("2d-shear", "A shear preserves no metric.", 2, [X, Y, "1 1 0 0 1 1/2"]),
    ("2d-singular", "A generator that is not invertible.", 2, [X, Y, "0 0 0 0 0 0"]),
    ("2d-scaling", "A generator that scales by two.", 2, [X, Y, "2 0 0 0 2 0"]),
    ("3d-two-translations", "Not cocompact.", 3, [A3, B3_]),
    ("3d-screw-only", "Not cocompact: one screw motion.", 3, ["0 -1 0 0 1 0 0 0 0 0 1 1/4"]),
    ("3d-metric-not-invariant", "The screw of the tetracosm needs A = B.", 3, None, "1 0 0 2 0 1", "tetracosm"),
    ("3d-metric-of-the-other-setting", "P3_1 with the metric of gamma = 60 degrees.", 3, None, "1 1/2 0 1 0 1", "P31"),
    ("3d-metric-nearly-invariant", "The glide of Pc is off by 10^-30 in the metric.", 3, None,
     "1 0.000000000000000000000000000001 0 1 0 1", "Pc"),
    ("3d-rotation-3-4-5", "A 49th linear part.", 3, T3 + ["3/5 -4/5 0 0 4/5 3/5 0 0 0 0 1 1/2"]),
    ("3d-singular", "A generator that is not invertible.", 3, T3 + ["1 0 0 0 0 1 0 0 0 0 0 0"]),
]:
    inadmissible(C, _name, _note, *_rest)
for _name, _note, *_rest in [
    ("2d-p2", "Half-turns.", 2, [X, Y, "-1 0 0 0 -1 0"]),
    ("2d-p2-moved", "Half-turns about (1/6, 5/14).", 2, [X, Y, "-1 0 1/3 0 -1 5/7"]),
    ("2d-pm", "Reflections.", 2, [X, Y, "-1 0 0 0 1 0"]),
    ("2d-pm-hidden", "A glide by a whole period: its line is a mirror.", 2, [X, Y, "-1 0 1/5 0 1 3"]),
    ("2d-cm", "Glides and, between them, mirrors.", 2, [X, Y, "0 1 1 1 0 0"]),
    ("2d-pgg", "Two glides without fixed points whose product is a half-turn.", 2, ["-1 0 1/2 0 1 1/2", "1 0 1/2 0 -1 1/2"]),
    ("2d-p4", "Quarter-turns.", 2, [X, "0 -1 0 1 0 0"]),
    ("2d-p6", "Turns by sixty degrees.", 2, [X, "1 -1 0 1 0 0"], "1 -1/2 1"),
    ("3d-P-1", "Inversion.", 3, T3 + ["-1 0 0 0 0 -1 0 0 0 0 -1 0"]),
    ("3d-Pm", "Mirror.", 3, T3 + ["1 0 0 0 0 -1 0 0 0 0 1 0"]),
    ("3d-P2", "Two-fold axis.", 3, T3 + ["-1 0 0 0 0 -1 0 0 0 0 1 0"]),
    ("3d-C2", "Centred: screws and two-fold axes alternate.", 3, T3[1:] + ["1 0 0 1/2 0 1 0 1/2 0 0 1 0", "-1 0 0 1/2 0 1 0 1/2 0 0 -1 0"]),
    ("3d-P21-c", "Screw and glide without fixed points, their product an inversion.", 3,
     T3 + ["-1 0 0 0 0 1 0 1/2 0 0 -1 1/2", "1 0 0 0 0 -1 0 1/2 0 0 1 1/2"]),
    ("3d-P21212", "Two screws whose product is a two-fold rotation.", 3,
     T3 + ["1 0 0 1/2 0 -1 0 1/2 0 0 -1 0", "-1 0 0 1/2 0 1 0 1/2 0 0 -1 0"]),
    ("3d-I212121", "P2_12_12_1 and a centring: two-fold axes.", 3,
     ["1 0 0 1/2 0 -1 0 1/2 0 0 -1 0", "-1 0 0 0 0 1 0 1/2 0 0 -1 1/2", "1 0 0 1/2 0 1 0 1/2 0 0 1 1/2"]),
    ("3d-R3", "Rhombohedral: the centring makes three-fold axes of the screws.", 3,
     T3 + ["1 0 0 2/3 0 1 0 1/3 0 0 1 1/3", "0 -1 0 0 1 -1 0 0 0 0 1 1/3"], "1 -1/2 0 1 0 1"),
    ("3d-P-4", "Rotoinversion.", 3, T3 + ["0 1 0 0 -1 0 0 0 0 0 -1 1/3"]),
    ("3d-P42", "A screw of which the square is a rotation.", 3, T3 + ["0 -1 0 0 1 0 0 0 0 0 1 1/2"]),
]:
    inadmissible(T, _name, _note, *_rest)
G = {k.split()[0]: v for k, *_, v, _ in CATALOGUE}
for _name, _note, *_rest in [
    ("2d-torus-claimed-klein-bottle", "", 2, G["torus"], None, "klein-bottle"),
    ("2d-klein-bottle-claimed-torus", "", 2, G["klein-bottle"], None, "p1"),
    ("3d-dicosm-claimed-torocosm", "", 3, G["dicosm"], None, "P1"),
    ("3d-Pc-claimed-Cc", "The same holonomy; H1 differs.", 3, G["first-amphicosm"], None, "Cc"),
    ("3d-Cc-claimed-Pc", "", 3, G["second-amphicosm"], None, "B1"),
    ("3d-Pca21-claimed-Pna21", "", 3, G["first-amphidicosm"], None, "B4"),
    ("3d-Pna21-claimed-Pca21", "", 3, G["second-amphidicosm"], None, "Pca21"),
    ("3d-Pca21-claimed-dicosm", "The same H1; orientability differs.", 3, G["first-amphidicosm"], None, "dicosm"),
    ("3d-didicosm-claimed-tetracosm", "The same order of the holonomy.", 3, G["didicosm"], None, "P43"),
    ("3d-P31-claimed-P65", "A mirror image, and of the wrong group.", 3, G["tricosm"], "1 -1/2 0 1 0 1", "P65"),
]:
    inadmissible(N, _name, _note, *_rest)

# ================================================================ subgroup.member

M = "subgroup.member"


def member(name, note, base, change):
    def make():
        instance, tri = base()
        change(tri)
        return instance, tri
    make.__name__, make.__doc__ = name, note
    entries[f"{M}/{name}"] = make, [M]


def set_subgroup(*texts):
    return lambda tri: setattr(tri, "subgroup", list(texts))


def list_element(text, dim):
    return lambda tri: tri.listed.append(element(dim, text))


def use_element(text, dim):
    def change(tri):
        i, g = tri.cells[0][1]
        tri.cells[0][1] = i, compose(element(dim, text), g)
    return change


member("2d-subgroup-0", "The trivial group has infinite index.", hand_kuhn_2d, set_subgroup())
member("2d-subgroup-identity", "The trivial group has infinite index.", hand_kuhn_2d, set_subgroup("1 0 0 0 1 0"))
member("2d-infinite-index", "One translation has infinite index.", hand_kuhn_2d, set_subgroup("1 0 3 0 1 0"))
member("2d-infinite-index-glides", "Two powers of one glide have infinite index.", hand_klein_grid_not_normal,
       set_subgroup("-1 0 0 0 1 3/2", "-1 0 0 0 1 5/2"))
member("2d-generator-outside", "(3/2, 0) is no translation of G.", hand_kuhn_2d, set_subgroup("1 0 3/2 0 1 0", "1 0 0 0 1 3"))
member("2d-generator-shear", "A shear is not in G (and generates no discrete group of isometries with the rest).", hand_kuhn_2d,
       set_subgroup("1 0 3 0 1 0", "1 0 0 0 1 3", "1 1 0 0 1 0"))
member("2d-generator-3-4-5", "A rotation of infinite order is not in G.", hand_kuhn_2d,
       set_subgroup("1 0 3 0 1 0", "1 0 0 0 1 3", "3/5 -4/5 0 4/5 3/5 0"))
member("2d-generator-singular", "A singular matrix is not in G.", hand_kuhn_2d,
       set_subgroup("1 0 3 0 1 0", "1 0 0 0 1 3", "0 0 0 0 0 0"))
member("2d-element-outside", "A vertex by the translation (1/2, 0).", hand_kuhn_2d, use_element("1 0 1/2 0 1 0", 2))
member("2d-element-outside-nearly", "A vertex by a translation off by 2^-60.", hand_kuhn_2d,
       use_element(f"1 0 1/{2 ** 60} 0 1 0", 2))
member("2d-element-linear-part", "A vertex by a reflection, which the Klein bottle group has only with a glide.", KLEIN,
       use_element("-1 0 0 0 1 0", 2))
member("2d-element-unused-outside", "An element that no cell uses is not in G.", hand_kuhn_2d, list_element("1 0 1/2 0 1 0", 2))
member("3d-subgroup-0", "The trivial group has infinite index.", hand_kuhn_3d, set_subgroup())
member("3d-infinite-index", "Two translations have infinite index.", hand_kuhn_3d, set_subgroup(*multiples(3, 3, 3)[:2]))
member("3d-infinite-index-screw", "A screw and one translation.", G4_45,
       set_subgroup("0 -1 0 0 1 0 0 0 0 0 1 -1/4", "1 0 0 0 0 1 0 0 0 0 1 5"))
member("3d-generator-outside", "A screw of the wrong pitch.", G4_45, set_subgroup(*multiples(1, 1, 1), "0 -1 0 0 1 0 0 0 0 0 1 1/2"))
member("3d-element-outside", "A vertex by half a translation.", hand_kuhn_3d, use_element("1 0 0 0 0 1 0 1/2 0 0 1 0", 3))
member("3d-element-singular-unused", "An unused element that is not invertible.", hand_kuhn_3d, list_element("0 " * 12, 3))


@entry(M, M)
def _3d_mirror_image():
    """A triangulation of the mirror image: instance P31, elements of P32."""
    i, t = P32_2()
    return Instance(3, i.points, "P31"), t


# ================================================================ vertices.complete

V = "vertices.complete"


def more_points(instance, *points):
    return Instance(instance.dim, list(instance.points) + list(points), instance.manifold, instance.generators, instance.metric)


@entry(V, V)
def _2d_missing_point():
    """A correct triangulation of all points but one."""
    i, t = TORUS()
    return more_points(i, "1/2 1/2"), t


@entry(V, V)
def _2d_missing_point_in_cover():
    """A point at the centre of the squares is in no cell."""
    i, t = hand_kuhn_2d()
    return more_points(i, "1/2 1/3"), t


@entry(V, V)
def _2d_missing_point_on_edge():
    """The missing point lies on an edge."""
    i, t = hand_kuhn_2d()
    return more_points(i, "1/2 0"), t


@entry(V, V)
def _2d_missing_copy():
    """One copy of the point in the cover is not a vertex: its star, a hexagon, is triangulated anew."""
    i = torus(metric="2 -1 2")
    sheet = kuhn_tri(i, (5, 5))
    hexagon = [(2, 2), (3, 2), (4, 3), (4, 4), (3, 4), (2, 3)]
    sheet.tri.cells = [c for c in sheet.tri.cells if (3, 3) not in {tuple(x % 5 for x in p) for p in lift(i, c)}]
    sheet.add(*([hexagon[0], hexagon[k], hexagon[k + 1]] for k in range(1, 5)))
    return i, sheet.tri


@entry(V, V)
def _2d_sublattice():
    """Only the points of (2Z)^2 are vertices: 9 of 36."""
    return torus(), kuhn_tri(torus(), (3, 3), scale=2).tri


@entry(V, V)
def _klein_missing_point():
    """A missing point in the Klein bottle."""
    i, t = KLEIN()
    return more_points(i, "1/2 1/7"), t


@entry(V, V)
def _klein_missing_point_others_twice():
    """A missing point beside points that are given twice, the second time by a glide: more points in the file than vertices,
    for two reasons."""
    i, t = duplicated(*KLEIN(), 1)
    return more_points(i, "1/2 1/7"), t


@entry(V, V + " delaunay.empty")
def _2d_missing_point_and_flip():
    """delaunay.empty fails across a facet even where it could not hold for want of a vertex."""
    i, t = _2d_flip()
    return more_points(i, "1/2 1/2"), t


@entry(V, V)
def _3d_missing_point():
    """A correct triangulation of all points but one."""
    i, t = T3_40()
    return more_points(i, "1/2 1/2 1/2"), t


@entry(V, V)
def _3d_sublattice():
    """Only the points of (2Z)^3 are vertices: 27 of 216."""
    return torus3(), kuhn_tri(torus3(), (3, 3, 3), scale=2).tri


@entry(V, f"{V} volume.exact topology.homology")
def _2d_cells_0():
    """No cell at all, one element."""
    return torus(), Triangulation([], multiples(3, 3), elements=[identity(2)])


@entry(V, f"{V} volume.exact topology.homology")
def _2d_elements_0():
    """No element, no cell."""
    return torus(), Triangulation([], multiples(3, 3))


@entry(V, f"{V} volume.exact topology.homology")
def _3d_elements_0():
    """No element, no cell."""
    return torus3(), Triangulation([])


@entry(V, f"{V} volume.exact topology.orientable topology.homology")
def _klein_cells_0():
    """No cell: the empty complex is orientable, the Klein bottle is not."""
    return Instance(2, ["0 1/3"], "klein-bottle"), Triangulation([])


# ================================================================ cells.nondegenerate, facets.paired

SI, NL, N2, CI = "simplices.injective", "skeleton.no-loop", "skeleton.no-2-cycle", "complex.intersection"
CN, FP, FO, VE, DE = "cells.nondegenerate", "facets.paired", "facets.opposite", "volume.exact", "delaunay.empty"


def t_junction(flat):
    sheet = kuhn_tri(torus(), (5, 5))
    drop = [{(0, 0), (1, 0), (1, 1)}, {(1, 0), (1, 1), (2, 1)}, {(1, 0), (2, 0), (2, 1)}]
    sheet.tri.cells = [c for c in sheet.tri.cells if set(lift(sheet.instance, c)) not in drop]
    sheet.add([(0, 0), (2, 0), (1, 1)], [(2, 0), (2, 1), (1, 1)])
    if flat:
        sheet.add([(0, 0), (1, 0), (2, 0)])
    return sheet.instance, sheet.tri


@entry(CN, CN)
def _2d_closed_t_junction():
    """A T-junction closed by a flat triangle: combinatorially a torus, every facet twice."""
    return t_junction(True)


@entry(FP, FP)
def _2d_t_junction():
    """Two edges on one side of a line meet one edge on the other: a tiling of the plane, not facet to facet."""
    return t_junction(False)


def mismatched_layers(slivers):
    sheet = kuhn_tri(torus3(), (3, 3, 3), mirror=lambda c: (0,) if c[2] == 0 else ())
    if slivers:
        for x, y in grid(3, 3):
            for z in (0, 1):
                sheet.add([(x, y, z), (x + 1, y, z), (x, y + 1, z), (x + 1, y + 1, z)])
    return sheet.instance, sheet.tri


@entry(CN, CN)
def _3d_slivers():
    """Two layers of cubes whose common squares have different diagonals, closed by flat tetrahedra."""
    return mismatched_layers(True)


@entry(FP, FP)
def _3d_mismatched_diagonals():
    """Two layers of cubes whose common squares have different diagonals."""
    return mismatched_layers(False)


@entry(CN, f"{CN} {FP}")
def _2d_flat_cell_added():
    """A flat triangle more in a correct triangulation."""
    i, t = torus(), kuhn_tri(torus(), (5, 5)).tri
    return i, with_cells(i, t, [(0, 0), (1, 1), (2, 2)])


@entry(CN, f"{CN} {FP}")
def _3d_flat_cell_added():
    """A flat tetrahedron more, on a square that keeps its diagonal."""
    i, t = hand_kuhn_3d()
    return i, with_cells(i, t, [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])


@entry(CN, f"{CN} {FP} {VE}")
def _3d_flat_cell_instead():
    """One vertex of a cell replaced so that the cell is flat."""
    i, t = hand_kuhn_3d()
    t.cells.pop(0)
    return i, with_cells(i, t, [(0, 0, 0), (1, 0, 0), (1, 1, 0), (2, 1, 0)])


def with_cells(instance, tri, *cells):
    sheet = Drawing(instance)
    sheet.tri = tri
    return sheet.add(*cells).tri


@entry(FP, f"{FP} {VE}")
def _2d_two_copies():
    """Two copies of everything: every facet four times."""
    i, t = hand_kuhn_2d()
    t.cells += [list(c) for c in t.cells]
    return i, t


@entry(FP, f"{FP} {VE}")
def _2d_two_copies_other_lifts():
    """Two copies of everything, the second by other lifts."""
    i, t = KLEIN()
    return i, Triangulation(t.cells + shuffled(i, t, 9).cells)


@entry(FP, f"{FP} {VE}")
def _3d_two_copies():
    """Two copies of everything: every facet four times."""
    i, t = hand_kuhn_3d()
    t.cells += [list(c) for c in t.cells]
    return i, t


def without(base, k):
    i, t = base()
    t.cells.pop(k)
    return i, t


def twice(base, k):
    i, t = base()
    t.cells.append(t.cells[k][::-1])
    return i, t


@entry(FP, f"{FP} {VE}")
def _2d_cell_missing():
    """One cell missing."""
    return without(TORUS, 5)


@entry(FP, f"{FP} {VE}")
def _3d_cell_missing():
    """One cell missing."""
    return without(T3_40, 5)


@entry(FP, f"{FP} {VE}")
def _2d_cell_doubled():
    """One cell twice."""
    return twice(TORUS, 5)


@entry(FP, f"{FP} {VE}")
def _3d_cell_doubled():
    """One cell twice."""
    return twice(T3_40, 5)


@entry(FP, FP)
def _2d_cell_missing_another_doubled():
    """One cell missing, another of the same area twice: the volume is exact, every vertex is there."""
    i, t = hand_kuhn_2d()
    t.cells[0] = t.cells[9]
    return i, t


@entry(FP, FP)
def _2d_cell_missing_another_doubled_at_the_end():
    """The same in 25 squares, at vertices that only the last cells of the file have."""
    i, t = torus(), kuhn_tri(torus(), (5, 5)).tri

    def vertices(cell):
        return {tuple(c % 5 for c in x) for x in lift(i, cell)}

    faulty = vertices(t.cells[0]) | vertices(t.cells[3])
    t.cells[0] = t.cells[3]
    t.cells.sort(key=lambda cell: bool(vertices(cell) & faulty))
    return i, t


@entry(FP, FP)
def _3d_cell_missing_another_doubled():
    """One cell missing, another of the same volume twice."""
    i, t = hand_kuhn_3d()
    t.cells[0] = t.cells[100]
    return i, t


@entry(FP, FP)
def _2d_wrong_element():
    """One vertex of one cell by the wrong element; the area happens to be the same."""
    i, t = hand_kuhn_2d()
    j, g = t.cells[0][0]
    a, b = lift(i, t.cells[0])[1:]
    t.cells[0][0] = j, compose(translation(*(y - x for x, y in zip(a, b))), g)
    return i, t


@entry(FP, f"{FP} {FO} {VE} {N2}")
def _klein_wrong_element():
    """One vertex of one cell by the wrong glide."""
    i, t = KLEIN()
    j, g = t.cells[0][0]
    t.cells[0][0] = j, compose(element(2, "-1 0 0 0 1 1/2"), g)
    return i, t


@entry(FP, f"{FP} {FO} {VE} {N2}")
def _3d_wrong_element():
    """One vertex of one cell by the wrong element."""
    i, t = G4_45()
    j, g = t.cells[0][0]
    t.cells[0][0] = j, compose(translation(0, 0, 1), g)
    return i, t


@entry(FP, f"{V} {FP} {VE}")
def _3d_one_cell():
    """A single cell."""
    i, t = T3_40()
    return i, Triangulation(t.cells[:1])


@entry(FP, f"{FP} {FO} {N2}")
def _klein_left_cosets():
    """A cover by a subgroup H that is not normal, its cells moved by h on the right instead of the left of their elements."""
    i, t = hand_klein_grid_not_normal()
    h = element(2, t.subgroup[1])
    t.cells[0] = [(k, compose(g, h)) if n else (k, g) for n, (k, g) in enumerate(t.cells[0])]
    return i, t


# ================================================================ facets.opposite and the pillows


def hexagon_pillow(where=(0, 0), sign=1):
    """Six points and two triangulations, of four triangles each, of the hexagon, glued along its boundary."""
    v = [(2, 0), (1, 2), (-1, 2), (-2, 0), (-1, -2), (1, -2)]
    v = [tuple(F(w) + sign * F(x) for w, x in zip(where, p)) for p in v]
    ear = lambda k: [v[k], v[(k + 1) % 6], v[(k + 2) % 6]]
    return v, [[v[k], v[k + 2], v[k + 4]] if n < 0 else ear(k + 2 * n) for k in (0, 1) for n in (-1, 0, 1, 2)]


def flat_torus(points, a, b, metric=None):
    return Instance(2, points, "torus", [f"1 0 {a} 0 1 0", f"1 0 0 0 1 {b}"], metric)


@entry(FO, f"{V} {FO} {VE} topology.euler topology.homology")
def _2d_pillow():
    """A pillow: two triangulations of one square glued along its boundary."""
    sheet = Drawing(torus(), multiples(3, 3))
    for mirror in ((), (0,)):
        sheet.add(*kuhn((0, 0), mirror))
    return sheet.instance, sheet.tri


@entry(FO, f"{FO} {DE} topology.euler topology.homology")
def _2d_pillow_of_all_points():
    """A pillow on a hexagon of half the torus' area: all points, the exact volume, and a sphere."""
    points, cells = hexagon_pillow()
    return finish(flat_torus(points, 8, 3), cells)


@entry(FO, f"{V} {FO} {VE} links.spheres topology.euler topology.homology")
def _2d_cell_twice_alone():
    """One triangle twice and nothing else: its facets occur twice, but a face is a set of vertices, so its faces are those of
    one triangle."""
    sheet = Drawing(torus(), multiples(3, 3))
    cell = next(kuhn((0, 0)))
    return sheet.instance, sheet.add(cell, cell[::-1]).tri


@entry(FO, f"{V} {FO} {VE} links.spheres topology.euler topology.homology")
def _3d_cell_twice_alone():
    """One tetrahedron twice and nothing else."""
    sheet = Drawing(torus3(), multiples(3, 3, 3))
    cell = next(kuhn((0, 0, 0)))
    return sheet.instance, sheet.add(cell, cell[::-1]).tri


def finish(instance, cells):
    sheet = Drawing(instance)
    sheet.add(*cells)
    return sheet.instance, sheet.tri


def annulus(width=4, x0=0, y0=0):
    """Points (bottom, middle, top) of an annulus of height 1 and its two sheets, as functions column -> cells."""
    b, m, t = ((lambda x, h=h: (F(x0 + x), F(y0) + h)) for h in (0, F(1, 2), 1))
    points = [f(x) for x in range(width) for f in (b, m, t)]
    half = lambda x: [[b(x), b(x + 1), m(x)], [m(x), m(x + 1), b(x + 1)], [m(x), m(x + 1), t(x)], [t(x), t(x + 1), m(x + 1)]]
    whole = lambda x: [[b(x), b(x + 1), t(x + 1)], [b(x), t(x), t(x + 1)]]
    return points, half, whole, (b, m, t)


@entry(FO, FO)
def _2d_annulus_pillow():
    """Two triangulations of an annulus of half the torus' area, glued along its boundary: a torus in the torus that has
    every vertex, the exact area, the right links and homology."""
    points, half, whole, _ = annulus()
    return finish(flat_torus(points, 4, 2), [c for x in range(4) for c in half(x) + whole(x)])


def slab(layers):
    """Kuhn triangulations of 3 x 3 cubes divided into layers of thickness 1/layers."""
    for x, y in grid(3, 3):
        for k in range(layers):
            for cell in kuhn((x, y, k)):
                yield [(F(a), F(b), F(c, layers)) for a, b, c in cell]


def flat_torus3(points, a, b, c):
    return Instance(3, points, "torocosm", [f"1 0 0 {a} 0 1 0 0 0 0 1 0", f"1 0 0 0 0 1 0 {b} 0 0 1 0", f"1 0 0 0 0 1 0 0 0 0 1 {c}"])


def heights(layers):
    return [(F(x), F(y), F(k, layers)) for x, y in grid(3, 3) for k in range(layers + 1)]


@entry(FO, FO)
def _3d_slab_pillow():
    """Two triangulations of a thickened torus of half the volume, glued along its two boundary tori: a 3-torus."""
    return finish(flat_torus3(heights(2), 3, 3, 2), [*slab(1), *slab(2)])


BIPYRAMID = [(0, 0, 0), (3, 0, 0), (0, 3, 0), (1, 1, 2), (1, 1, -2)]


def bipyramid_pillow(where):
    p = [tuple(F(a) + F(w) for a, w in zip(q, where)) for q in BIPYRAMID]
    return p, [[p[0], p[1], p[2], p[3]], [p[0], p[1], p[2], p[4]]] + [[p[3], p[4], p[a], p[b]] for a, b in ((0, 1), (1, 2), (0, 2))]


@entry(FO, f"{FO} topology.homology")
def _3d_pillow():
    """The two and the three tetrahedra on five points, glued along their boundary: a 3-sphere of the exact volume."""
    points, cells = bipyramid_pillow((0, 0, 0))
    return finish(flat_torus3(points, 4, 4, F(3, 4)), cells)


# ================================================================ volume.exact: several sheets


def forget(base, claim, generators, metric=None):
    """The same points and cells, claimed for a larger group."""
    i, t = base()
    return Instance(i.dim, i.points, claim, generators, metric or i.metric), t


def triangulated(name, instance):
    return engine_file(name, instance, False)


TORUS2 = triangulated("torus-2x1-24", Instance(2, kronecker(2, 24, (2, 1)), "torus", ["1 0 2 0 1 0", Y]))
KLEIN2 = triangulated("torus-over-klein-24", Instance(2, kronecker(2, 24), "torus", metric="1 0 1"))
KLEIN3 = triangulated("klein-bottle-tall-24", Instance(2, kronecker(2, 24, (1, 3)), "klein-bottle", [X, "-1 0 0 0 1 3/2"]))
T3_2 = triangulated("torocosm-2x1x1-60", Instance(3, kronecker(3, 60, (2, 1, 1)), "torocosm", ["1 0 0 2 0 1 0 0 0 0 1 0", B3_, C3]))
G2_B3 = triangulated("dicosm-over-amphidicosm-60", Instance(3, kronecker(3, 60), "dicosm", metric="2 0 0 1 0 4"))


@entry(VE, VE)
def _2d_double_cover():
    """A connected double cover with one vertex over each point: every other condition holds."""
    return forget(TORUS2, "torus", [X, Y])


@entry(VE, VE)
def _klein_triple_cover():
    """A connected triple cover of the Klein bottle by the Klein bottle with one vertex over each point."""
    return forget(KLEIN3, "klein-bottle", [X, "-1 0 0 0 1 1/2"])


@entry(VE, VE)
def _3d_double_cover():
    """A connected double cover with one vertex over each point: every other condition holds."""
    return forget(T3_2, "torocosm", T3)


@entry(VE, f"{VE} links.spheres topology.euler")
def _3d_checkerboard_double_cover():
    """Five tetrahedra per cube, alternating: invariant under an index-2 subgroup only, claimed for (3Z)^3. Every facet
    twice, on opposite sides, locally Delaunay, no loop, no 2-cycle: a connected double cover. (H1 is right, too.)"""
    sheet = Drawing(torus3(), multiples(3, 3, 3))
    for corner in grid(3, 3, 3):
        for parity in (0, 1):
            sheet.add(*five(corner, parity))
    return sheet.instance, sheet.tri


# ================================================================ delaunay.empty


def first_flip(base, kind, skip=0):
    """The skip-th flip after which delaunay.empty alone fails."""
    i, t = base()
    for u in flips(i, t, kind):
        if [n for n, s in Judge(i, u).status.items() if s == "fails"] == [DE]:
            if not skip:
                return i, u
            skip -= 1
    raise AssertionError("no such flip")


@entry(DE, DE)
def _2d_flip():
    """A 2-2 flip in a correct triangulation."""
    return first_flip(TORUS, "2-2", 3)


@entry(DE, DE)
def _klein_flip():
    """A 2-2 flip in the Klein bottle."""
    return first_flip(KLEIN, "2-2", 5)


@entry(DE, DE)
def _3d_flip_2_3():
    """A 2-3 flip in a correct triangulation."""
    return first_flip(T3_40, "2-3")


@entry(DE, DE)
def _3d_flip_3_2():
    """A 3-2 flip in a correct triangulation."""
    return first_flip(T3_40, "3-2")


@entry(DE, DE)
def _amphidicosm_flip_2_3():
    """A 2-3 flip in the first amphidicosm."""
    return first_flip(B3_45, "2-3")


@entry(DE, DE)
def _2d_metric_changed():
    """A correct triangulation, but for the mirror image of this metric."""
    return torus(metric="2 1 2"), kuhn_tri(torus(metric="2 1 2"), (4, 4)).tri


@entry("valid")
def metric_of_2d_metric_changed():
    """The same cells with the metric for which they are right."""
    return torus(metric="2 -1 2"), kuhn_tri(torus(), (4, 4)).tri


@entry(DE, DE)
def _2d_metric_nearly_square():
    """A metric off the square one by 10^-40, against all diagonals."""
    return torus(metric="1 1e-40 1"), kuhn_tri(torus(), (4, 4)).tri


@entry("valid")
def metric_nearly_square_2d():
    """A metric off the square one by 10^-40, in favour of all diagonals."""
    return torus(metric="1 -1e-40 1"), kuhn_tri(torus(), (4, 4)).tri


@entry(DE, DE)
def _3d_metric_changed():
    """The Kuhn triangulation with a metric for which it is not Delaunay."""
    return torus3(metric="3 1 1 3 1 3"), kuhn_tri(torus3(), (3, 3, 3)).tri


@entry("valid")
def metric_of_3d_metric_changed():
    """The Kuhn triangulation with a metric of Selling's form."""
    return torus3(metric="3 -1 -1 3 -1 3"), kuhn_tri(torus3(), (3, 3, 3)).tri


@entry(DE, DE)
def _2d_point_moved():
    """A grid of which one point was moved by 2^-60, into the circle of its neighbours; the diagonals ignore it."""
    return moved_grid((0,))


@entry("valid")
def point_moved_2d():
    """The moved grid with diagonals that respect the move."""
    return moved_grid(())


# A rotated square of side 5/(3 * 2^16) about (1/3, 1/7), one corner of which was moved inwards by 2^-80: its diagonal through
# that corner is the Delaunay edge. Rounded to doubles, the corners move by more than that and by different amounts, and their
# differences are exact: only the error of the coordinates themselves can tell that the rounded square decides nothing.
CLOSE = [(F(1, 3) + F(x, 3 * 2 ** 16), F(1, 7) + F(y, 3 * 2 ** 16)) for x, y in ((3, 4), (-4, 3), (-3, -4), (4, -3))]
CLOSE[2] = tuple(x + F(1, 2 ** 80) for x in CLOSE[2])
CLOSE_POINTS = engine_file("torus-close-points", torus(kronecker(2, 24) + CLOSE), False)


@entry(DE, DE)
def _2d_close_points():
    """torus-close-points with the other diagonal in its small square: wrong by 2^-80."""
    i, t = CLOSE_POINTS()
    small = {24, 25, 26, 27}
    for u in flips(i, t, "2-2"):
        gone = [c for c in t.cells if c not in u.cells]
        if all({k for k, _ in c} < small for c in gone):
            return i, u
    raise AssertionError("no such flip")


@entry(DE, DE)
def _3d_point_moved():
    """A correct triangulation of a grid of which one point was then moved by 2^-60."""
    points = [(F(a, 3), F(b, 3), F(c, 3)) for a, b, c in grid(3, 3, 3)]
    sheet = Drawing(torus3(points))
    for corner in grid(3, 3, 3):
        sheet.add(*([tuple(F(v, 3) for v in x) for x in cell] for cell in kuhn(corner)))
    points[13] = tuple(v + F(1, 2 ** 60) for v in points[13])
    return torus3(points), sheet.tri


# ================================================================ skeleton, simplices, complex


def loops(folder, name, note, fails, make):
    def wrapped():
        return make()
    wrapped.__name__, wrapped.__doc__ = name, note
    entries[f"{folder}/{name}"] = wrapped, fails.split()


def klein_one_vertex():
    i = Instance(2, ["1/4 0"], "klein-bottle")
    return finish(i, [[(F(1, 4), F(0)), (F(-1, 4), F(1, 2)), (F(1, 4), F(1))], [(F(1, 4), F(0)), (F(3, 4), F(1, 2)), (F(1, 4), F(1))]])


def covered(base, subgroup):
    i, t = base()
    return i, cover(i, t, subgroup)


loops(SI, "2d-one-vertex", "One vertex, three loops, two triangles.", LOOP, lambda: (torus(), kuhn_tri(torus(), (1, 1), False).tri))
loops(SI, "3d-one-vertex", "One vertex, seven loops, six tetrahedra.", LOOP, lambda: (torus3(), kuhn_tri(torus3(), (1, 1, 1), False).tri))
loops(SI, "didicosm-one-vertex", "One generic point of the didicosm without a cover.", LOOP, lambda: covered(ONE["didicosm"], None))


def loops_at_far_corners(*sizes):
    """A narrow cover in which each cell has one loop, listed from its first vertex to its last."""
    sheet = Drawing(torus3() if len(sizes) == 3 else torus(), multiples(*sizes))
    for corner in grid(*sizes):
        for cell in kuhn(corner):
            a, b = next((x, y) for x in cell for y in cell if y[0] == x[0] + 1 and y[1:] == x[1:])
            sheet.add([a, *(x for x in cell if x not in (a, b)), b])
    return sheet.instance, sheet.tri


loops(SI, "2d-first-and-last-vertex", "The cover <(1,0), (0,3)>, the two equal vertices of each cell listed first and last.", LOOP,
      lambda: loops_at_far_corners(1, 3))
loops(SI, "3d-first-and-last-vertex", "The same for <1, 3, 3>.", LOOP, lambda: loops_at_far_corners(1, 3, 3))
loops(NL, "2d-narrow-cover", "The cover <(1,0), (0,3)>: one loop at every vertex.", LOOP, lambda: (torus(), kuhn_tri(torus(), (1, 3)).tri))
loops(NL, "3d-narrow-cover", "The cover <1, 3, 3>: one loop at every vertex.", LOOP, lambda: (torus3(), kuhn_tri(torus3(), (1, 3, 3)).tri))
loops(NL, "klein-one-vertex", "Two triangles, each glued to itself by a glide: its edge modulo H occurs twice in one cell.", LOOP,
      klein_one_vertex)
loops(NL, "dicosm-screw-loop", "A cover of the dicosm in which a screw still joins copies.", LOOP,
      lambda: covered(ONE["dicosm"], multiples(3, 3, 1)[:2] + ["-1 0 0 0 0 -1 0 0 0 0 1 1/2"]))
loops(N2, "2d-cover-too-small", "The cover <(2,0), (0,3)>: two edges between the ends of each row.", CYCLE,
      lambda: (torus(), kuhn_tri(torus(), (2, 3)).tri))
loops(N2, "3d-cover-too-small", "The cover <2, 3, 3>.", CYCLE, lambda: (torus3(), kuhn_tri(torus3(), (2, 3, 3)).tri))
loops(N2, "2d-checkerboard", "Delta = delta/2 exactly, all diagonals horizontal: 2-cycles.", CYCLE, lambda: checkerboard(lambda i, j: True))
loops(N2, "klein-cover-too-small", "One generic point of the Klein bottle in the torus <(2,0), (0,2)>.", CYCLE,
      lambda: covered(ONE["klein-bottle"], multiples(2, 2)))
loops(N2, "didicosm-dicosm-cover-too-small", "One generic point of the didicosm modulo a dicosm of index 54: 3Z^3 is enough, a screw's"
      " cube more is not.", CYCLE, lambda: covered(ONE["didicosm"], multiples(3, 3, 3) + ["1 0 0 3/2 0 -1 0 1/2 0 0 -1 0"]))
loops(CI, "2d-cover-too-small", "The cover <(2,0), (0,2)>: edges and triangles with the same vertices.", CYCLE,
      lambda: (torus(), kuhn_tri(torus(), (2, 2)).tri))
loops(CI, "2d-not-normal-too-small", "A Klein bottle grid modulo <(2,0), glide^3>, which is not normal in the bottle's group.", CYCLE,
      lambda: klein_grid(["1 0 2 0 1 0", "-1 0 0 0 1 3/2"], 2, 3))
loops(CI, "3d-cover-too-small", "The cover (2Z)^3.", CYCLE, lambda: (torus3(), kuhn_tri(torus3(), (2, 2, 2)).tri))
loops(CI, "dicosm-cover-too-small", "One generic point of the dicosm modulo (2Z)^3.", CYCLE,
      lambda: covered(ONE["dicosm"], multiples(2, 2, 2)))
loops(CI, "tetracosm-not-normal-too-small", "One generic point of the tetracosm modulo <2Z^2, screw^5>, not normal.", CYCLE,
      lambda: covered(ONE["tetracosm"], multiples(2, 2, 5)[:2] + ["0 -1 0 0 1 0 0 0 0 0 1 5/4"]))

@entry(N2, CYCLE)
def _2d_two_points_in_the_last_row():
    """Seven rows of four points around a torus, and one of two, with two edges between them: of all vertices the last."""
    rows = [[F(i, 4) for i in range(4)]] * 7 + [[F(0), F(1, 2)]]
    sheet = Drawing(torus([(x, F(j, 8)) for j, row in enumerate(rows) for x in row], metric="1 0 16"))
    for corner in grid(4, 6):
        sheet.add(*([(F(x, 4), F(y, 8)) for x, y in cell] for cell in kuhn(corner)))
    # The strips on both sides of the last row are a half turn of each other.
    for turn in (lambda x, y: (x, y), lambda x, y: (-x, F(7, 4) - y)):
        for x in (F(0), F(1, 2)):
            last, *row = [(x, F(7, 8))], *((x + F(i, 4), F(3, 4)) for i in (-1, 0, 1))
            for cell in (row[:2] + last, row[1:] + last, row[2:] + last + [(x + F(1, 2), F(7, 8))]):
                sheet.add([turn(*v) for v in cell])
    return sheet.instance, sheet.tri


# ================================================================ links

LS = "links.spheres"
TC, TE, TO, TH = "topology.connected", "topology.euler", "topology.orientable", "topology.homology"


@entry(LS, f"{FO} {DE} {LS}")
def _2d_two_pinches():
    """A pillow on two hexagons whose two sheets meet in the two centres as well: a sphere pinched twice has the Euler
    number and the homology of the torus."""
    first, _ = hexagon_pillow()
    second, _ = hexagon_pillow((0, 4), -1)
    cells = []
    for k, centre in ((0, None), (1, None)):
        for v, o in ((first, (F(0), F(0))), (second, (F(0), F(4)))):
            for n in range(3):
                a, b, c = (v[(k + 2 * n + j) % 6] for j in range(3))
                cells += [[a, b, c], [a, c, o]]
    # On the even sheet the edge v1 v2 that the hexagons share is flipped: it may bound cells of one sheet only.
    shared = {first[1], first[2]}
    even = [c for c in cells if shared < set(c)]
    ends = [next(x for x in c if x not in shared) for c in even]
    gone = [c for c, x in zip(even, ends) if x in (first[0], second[0])]
    assert len(gone) == 2
    cells = [c for c in cells if c not in gone] + [[first[0], second[0], first[1]], [first[0], second[0], first[2]]]
    points = list(dict.fromkeys(first + second + [(F(0), F(0)), (F(0), F(4))]))
    return finish(flat_torus(points, 5, F(48, 5)), cells)


@entry(LS, f"{FO} {DE} {LS}")
def _3d_shared_edge():
    """The slab pillow with three layers in one sheet, one vertex of which is a vertex inside the other sheet as well: the
    sheets share it and an edge. Euler number and homology are those of the 3-torus."""
    return pinched_slab(3, (F(2, 30), F(1, 30), F(1, 3)))


def pinched_slab(layers, c):
    old = (F(0), F(0), c[2])
    shift = lambda x: tuple(v + w - u for v, w, u in zip(x, c, old)) if tuple(w % 3 for w in x[:2]) == (0, 0) and x[2] == c[2] else x
    many = [[shift(x) for x in cell] for cell in slab(layers)]
    one = []
    for cell in slab(1):
        if set(cell) == {(0, 0, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1)}:
            one += [[c if k == j else x for k, x in enumerate(cell)] for j in range(4)]
        else:
            one.append(cell)
    return finish(flat_torus3([c if x == old else x for x in heights(layers)], 3, 3, 2), many + one)


@entry(LS, f"{FO} {DE} {LS} {TE} {TH}")
def _3d_shared_vertex():
    """The same with four layers: the sheets share an inner vertex and no inner edge."""
    return pinched_slab(4, (F(2, 30), F(1, 30), F(1, 2)))


@entry(LS, f"{FO} {LS} {TC} {TE} {TH}")
def _3d_two_pillows_at_a_vertex():
    """Two 3-spheres that meet in one vertex, of the exact volume."""
    p, a = bipyramid_pillow((0, 0, 0))
    q, b = bipyramid_pillow((3, 0, 0))
    return finish(flat_torus3(list(dict.fromkeys(p + q)), 7, 4, F(6, 7)), a + b)


def suspended_torus():
    """The torus of seven vertices (triangles {i, i+1, i+3} and {i, i+2, i+3} modulo 7) and the cones over it from two apexes."""
    rim = [(F(k), F(k * k % 7), F(k ** 3, 343)) for k in range(7)]
    north, south = (F(0), F(0), F(8)), (F(9), F(1), F(-5))
    faces = [[rim[(i + k) % 7] for k in (0, step, 3)] for i in range(7) for step in (1, 2)]
    return (north, south), [north, south, *rim], [[apex, *face] for apex in (north, south) for face in faces]


def of_their_volume(points, cells):
    """The cells in a cubic torus of the exact volume."""
    det = lambda u, v, w: sum(u[i] * (v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2]) for i in range(3))
    total = sum(abs(det(*([a - b for a, b in zip(x, c[0])] for x in c[1:]))) for c in cells) / 6
    return finish(flat_torus3(points, 20, 20, total / 400), cells)


@entry(LS, f"{FO} {DE} {LS} {TE} {TH}")
def _3d_torus_as_link():
    """The suspension of a torus: the links of its two apexes are closed and connected, and no spheres."""
    _, points, cells = suspended_torus()
    return of_their_volume(points, cells)


@entry(LS, f"{FO} {DE} {LS} {TC} {TH}")
def _3d_torus_and_sphere_as_link():
    """The same with a 3-sphere at each apex: its link, a torus and a sphere, has the Euler number of a sphere."""
    apexes, points, cells = suspended_torus()
    for apex in apexes:
        more, pillow = bipyramid_pillow(apex)
        points, cells = points + more, cells + pillow
    return of_their_volume(list(dict.fromkeys(points)), cells)


@entry(LS, f"{V} {FO} {VE} {LS} {TC} {TE} {TH}")
def _2d_two_squares_at_a_vertex():
    """Two pillows on squares that share a corner: a pinched vertex."""
    sheet = Drawing(torus(), multiples(4, 4))
    for corner in ((0, 0), (1, 1)):
        for mirror in ((), (0,)):
            sheet.add(*kuhn(corner, mirror))
    return sheet.instance, sheet.tri


# ================================================================ topology


@entry(TC, f"{VE} {TC} {TH}")
def _2d_two_tori():
    """Two tori, each a correct triangulation of half the points."""
    i = torus(["0 0", "1/3 1/2"])
    sheet = kuhn_tri(i, (3, 3))
    sheet.tri.cells += [[(1, g) for _, g in c] for c in sheet.tri.cells]
    return i, sheet.tri


@entry(TC, f"{VE} {TC} {TH}")
def _3d_two_tori():
    """Two 3-tori, each a correct triangulation of half the points."""
    i = torus3(["0 0 0", "1/3 1/2 1/5"])
    sheet = kuhn_tri(i, (3, 3, 3))
    sheet.tri.cells += [[(1, g) for _, g in c] for c in sheet.tri.cells]
    return i, sheet.tri


@entry(TC, f"{FO} {TC} {TH}")
def _2d_two_annulus_pillows():
    """Two annulus pillows side by side: all points, the exact area, two tori."""
    p, half, whole, _ = annulus()
    q, half2, whole2, _ = annulus(y0=2)
    return finish(flat_torus(p + q, 4, 4), [c for x in range(4) for f in (half, whole, half2, whole2) for c in f(x)])


@entry(TC, f"{FO} {TC}")
def _3d_torus_and_sphere():
    """The slab pillow and a 3-sphere on five points of their own: two components, but H1 and Euler number are right."""
    s, cells = bipyramid_pillow((0, 0, 0))
    s, cells = ([tuple(v / 5 + w for v, w in zip(x, (F(1, 3), F(1, 7), F(3, 2)))) for x in y] for y in (s, sum(cells, [])))
    cells = [cells[k:k + 4] for k in range(0, len(cells), 4)]
    return finish(flat_torus3(heights(2) + s, 3, 3, 2 + F(12, 125) / 9), [*slab(1), *slab(2)] + cells)


@entry(TE, f"{FO} {TE} {TH}")
def _2d_sphere():
    """A pillow on a hexagon of half the torus' area, its corners on a circle: Euler number 2."""
    points, cells = hexagon_pillow((F(1, 7), F(1, 3)))
    return finish(flat_torus(points, F(24, 5), 5, "1 0 3/4"), cells)


@entry(TE, f"{FO} {DE} {LS} {TE} {TH}")
def _3d_pinched():
    """A 3-torus with two vertices made one: Euler number -1."""
    return pinched_slab(4, (F(3, 40), F(1, 30), F(1, 2)))


@entry(TO, f"{VE} {TO} {TH}")
def _2d_torus_over_klein_bottle():
    """The orientable double cover of the Klein bottle, one vertex over each point: the wrong manifold with the same
    local structure."""
    return forget(KLEIN2, "klein-bottle", G["klein-bottle"])


@entry(TO, f"{VE} {TO}")
def _3d_dicosm_over_amphidicosm():
    """The orientable double cover of Pca2_1, one vertex over each point. It is a dicosm, of the same homology."""
    return forget(G2_B3, "Pca21", G["first-amphidicosm"])


@entry(TO, f"{FO} {TO} {TH}")
def _2d_klein_bottle_in_torus():
    """The annulus pillow with its two sheets exchanged along a cut: a Klein bottle folded into the torus."""
    points, half, whole, (b, m, t) = annulus(5)
    # From column 0 to 1 the sheets change places: one turns from three vertices per section to two, the other back.
    turn = [[b(0), b(1), m(0)], [m(0), b(1), t(1)], [m(0), t(1), t(0)]]
    back = [[b(0), t(0), m(1)], [b(0), b(1), m(1)], [m(1), t(1), t(0)]]
    return finish(flat_torus(points, 5, 2), turn + back + [c for x in range(1, 5) for c in half(x) + whole(x)])


T3_G2 = triangulated("torocosm-over-dicosm-60", Instance(3, kronecker(3, 60), "torocosm", metric="1 0 0 1 0 2"))


@entry(TH, f"{VE} {TH}")
def _3d_dicosm_over_tetracosm():
    """The double cover of the tetracosm, one vertex over each point: a dicosm, whose H1 has the same rank and other torsion."""
    return forget(G2_50, "tetracosm", G["tetracosm"])


@entry(TH, f"{VE} {TH}")
def _3d_torus_over_dicosm():
    """The 3-torus that covers the dicosm twice, one vertex over each point: only volume and homology tell."""
    return forget(T3_G2, "P21", G["dicosm"])


@entry(TH, f"{FO} {TH}")
def _3d_sphere():
    """A 3-sphere of all points and the exact volume: of the topology only the homology tells."""
    points, cells = bipyramid_pillow((F(1, 5), F(1, 3), F(2, 7)))
    return finish(flat_torus3(points, 5, 4, F(3, 5)), cells)


@entry(TH, f"{VE} {TC} {TH}")
def _2d_two_tori():
    """Two tori of different shifts: H1 is Z^4."""
    i = torus(["0 0", "1/2 1/3"], "1 0 2")
    sheet = kuhn_tri(i, (4, 3))
    sheet.tri.cells += [[(1, g) for _, g in c] for c in sheet.tri.cells]
    return i, sheet.tri


# ================================================================ numbers beyond 64 bits
# Every geometric condition alone once more, in numbers for which a checker's fast arithmetic is too narrow.


def klein_squares(columns, rows, cells, points=None):
    """The Klein bottle of columns x rows unit squares with the given cells, on all their corners."""
    points = points or [(F(x), F(y)) for x, y in grid(columns, rows)]
    generators = [f"1 0 {columns} 0 1 0", f"-1 0 0 0 1 {rows}"]
    return finish(Instance(2, points, "klein-bottle", generators), cells)


def klein_closed_t_junction():
    drop = [{(0, 0), (1, 0), (1, 1)}, {(1, 0), (1, 1), (2, 1)}, {(1, 0), (2, 0), (2, 1)}]
    cells = [c for corner in grid(5, 5) for c in kuhn(corner) if set(c) not in drop]
    cells += [[(0, 0), (2, 0), (1, 1)], [(2, 0), (2, 1), (1, 1)], [(0, 0), (1, 0), (2, 0)]]
    return klein_squares(5, 5, cells)


def klein_annulus_pillow():
    points, half, whole, _ = annulus()
    i, t = klein_squares(4, 2, [c for x in range(4) for c in half(x) + whole(x)], points)
    return i, shuffled(i, t, 5)


def one_moved(instance, tri, k):
    """The k-th point moved by 2^-60 along every axis: out of the ball of one neighbouring cube, into that of another."""
    points = list(instance.points)
    points[k] = tuple(v + F(1, 2 ** 60) for v in points[k])
    return with_points(instance, points), tri


def klein_point_moved():
    return one_moved(*klein_squares(4, 4, [c for corner in grid(4, 4) for c in kuhn(corner)]), 5)


def dicosm_point_moved():
    """Cubes of edge 1 between two planes that a screw exchanges; it keeps the diagonals of their squares."""
    points = [(F(x), F(y), F(z)) for x, y, z in grid(4, 4, 4)]
    generators = ["1 0 0 4 0 1 0 0 0 0 1 0", "1 0 0 0 0 1 0 4 0 0 1 0", "-1 0 0 0 0 -1 0 0 0 0 1 4"]
    cells = [c for corner in grid(4, 4, 4) for c in kuhn(corner)]
    return one_moved(*finish(Instance(3, points, "dicosm", generators), cells), 21)


def in_large_numbers(folder, name, note, fails, make, change=None):
    def wrapped():
        return change(*make()) if change else make()
    wrapped.__name__ = name + (f"-{change.__name__}" if change else "")
    wrapped.__doc__ = note + {None: "", far: " All points moved by one vector with denominator 3^50.",
                              apart: " Every coordinate moved by less than 10^-24, to a large denominator of its own.",
                              coprime: " Every coordinate moved by less than 2^-33, to one of two denominators of 34 bits."}[change]
    entries[f"{folder}/{wrapped.__name__}"] = wrapped, fails.split()


def with_missing_point(base, point):
    i, t = base()
    return more_points(i, point), t


for _folder, _name, _change in [
    (V, "2d-missing-point", apart), (V, "2d-missing-point", coprime), (V, "klein-missing-point-others-twice", far),
    (V, "3d-sublattice", far),
    (CN, "2d-closed-t-junction", far), (CN, "3d-slivers", far), (FO, "2d-annulus-pillow", far), (FO, "3d-slab-pillow", far),
    (VE, "2d-double-cover", apart), (VE, "klein-triple-cover", apart), (VE, "3d-double-cover", apart),
    (DE, "2d-flip", apart), (DE, "klein-flip", apart), (DE, "klein-flip", coprime), (DE, "3d-flip-2-3", apart),
    (DE, "amphidicosm-flip-2-3", apart), (DE, "2d-point-moved", far), (DE, "2d-close-points", far), (DE, "3d-point-moved", far),
]:
    _make, _fails = entries[f"{_folder}/{_name}"]
    in_large_numbers(_folder, _name, _make.__doc__, " ".join(_fails), _make, _change)
for _folder, _name, _note, _fails, *_rest in [
    (V, "tetracosm-missing-point", "A missing point in the tetracosm (mirror image).", V,
     lambda: with_missing_point(G4_45, "1/2 1/3 1/31"), apart),
    (V, "amphicosm-missing-point-others-twice", "A missing point beside points that are given twice, in the second amphicosm.",
     V, lambda: with_missing_point(lambda: duplicated(*B2_45(), 2), "1/2 1/3 1/31"), far),
    (CN, "klein-closed-t-junction", "A T-junction closed by a flat triangle in the Klein bottle.", CN,
     klein_closed_t_junction, far),
    (FO, "klein-annulus-pillow", "An annulus pillow, a torus folded into the Klein bottle, drawn by other lifts.",
     f"{FO} {TO} {TH}", klein_annulus_pillow, far),
    (DE, "klein-point-moved", "Squares of a Klein bottle of which one corner was moved by 2^-60.", DE, klein_point_moved, far),
    (DE, "dicosm-point-moved", "Cubes of a dicosm of which one corner was moved by 2^-60.", DE, dicosm_point_moved, far),
    (DE, "2d-metric-of-large-numbers", "Unit squares cut along the longer diagonals, in a metric of 100 bits.", DE,
     lambda: (torus(metric=f"{2 * 10 ** 30 + 1} {10 ** 30 + 7} {2 * 10 ** 30 + 3}"), kuhn_tri(torus(), (4, 4)).tri)),
    (DE, "3d-metric-of-large-numbers", "The Kuhn triangulation in a metric of 100 bits for which it is not Delaunay.", DE,
     lambda: (torus3(metric=" ".join(str(k * 10 ** 30 + a) for k, a in ((3, 1), (1, 3), (1, 7), (3, 11), (1, 13), (3, 17)))),
              kuhn_tri(torus3(), (3, 3, 3)).tri)),
    (DE, "3d-metric-nearly-cubic", "A metric off the cubic one by 10^-40, against the diagonals of the squares in one direction.",
     DE, lambda: (torus3(metric="1 1e-40 0 1 0 1"), kuhn_tri(torus3(), (3, 3, 3)).tri)),
]:
    in_large_numbers(_folder, _name, _note, _fails, *_rest)


def main():
    global engine
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--engine", help="flatdt, to make its files in corpora/valid anew")
    parser.add_argument("names", nargs="*", help="parts of names; default: all")
    args = parser.parse_args()
    engine = args.engine
    good = True
    for name, (make, fails) in entries.items():
        if not args.names or any(part in name for part in args.names):
            folder = name if name.startswith("valid/") else "invalid/" + name
            good = emit(folder, make, fails) and good
    if not args.names:
        import malformed
        malformed.make(os.path.join(ROOT, "invalid", "malformed"), record)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
