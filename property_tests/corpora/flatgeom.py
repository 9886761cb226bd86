"""Exact geometry of flat manifolds for the corpus: files, group elements, lattices, groups, Smith invariants.

Python standard library only. It shares nothing with ref/ or checker/: it is the third opinion from which the records of
corpora/ were made. Simple and slow (Fractions everywhere).   Source: FORMAT.md, DESIGN.md sections 3 and 6.
"""

import itertools
import re
from fractions import Fraction as F
from math import factorial, gcd, lcm

# ---------------------------------------------------------------- group elements: (R, t), R a tuple of rows


def element(dim, text):
    """The augmented matrix [R|t] written row by row."""
    values = [number(word) for word in text.split()] if isinstance(text, str) else [F(v) for v in text]
    assert len(values) == dim * (dim + 1), text
    rows = [values[i * (dim + 1):(i + 1) * (dim + 1)] for i in range(dim)]
    return tuple(tuple(row[:dim]) for row in rows), tuple(row[dim] for row in rows)


def identity(dim):
    return tuple(tuple(F(i == j) for j in range(dim)) for i in range(dim)), (F(0),) * dim


def translation(*vector):
    return identity(len(vector))[0], tuple(F(v) for v in vector)


def apply(g, x):
    return tuple(sum(r * v for r, v in zip(row, x)) + s for row, s in zip(g[0], g[1]))


def matmul(a, b):
    return tuple(tuple(sum(a[i][k] * b[k][j] for k in range(len(b))) for j in range(len(b[0]))) for i in range(len(a)))


def compose(g, h):
    """g after h."""
    return matmul(g[0], h[0]), apply(g, h[1])


def det(m):
    if len(m) == 1:
        return m[0][0]
    return sum((-1) ** j * m[0][j] * det([row[:j] + row[j + 1:] for row in m[1:]]) for j in range(len(m)))


def solve(a, b):
    """x with a x = b for a square matrix; None if it is singular."""
    n = len(a)
    rows = [list(a[i]) + [b[i]] for i in range(n)]
    for c in range(n):
        p = next((r for r in range(c, n) if rows[r][c] != 0), None)
        if p is None:
            return None
        rows[c], rows[p] = rows[p], rows[c]
        rows[c] = [v / rows[c][c] for v in rows[c]]
        for r in range(n):
            if r != c and rows[r][c] != 0:
                rows[r] = [v - rows[r][c] * w for v, w in zip(rows[r], rows[c])]
    return tuple(row[n] for row in rows)


def inverse(g):
    dim = len(g[1])
    columns = [solve(g[0], [F(i == j) for i in range(dim)]) for j in range(dim)]
    r = tuple(tuple(columns[j][i] for j in range(dim)) for i in range(dim))
    return r, tuple(-v for v in apply((r, (F(0),) * dim), g[1]))


# ---------------------------------------------------------------- lattices and abelian groups


def echelon(rows):
    """Row echelon basis of the Z-module that rational rows generate."""
    rows = [list(map(F, row)) for row in rows]
    scale = lcm(1, *[v.denominator for row in rows for v in row])
    rows = [[int(v * scale) for v in row] for row in rows]
    width = len(rows[0]) if rows else 0
    done = []
    for c in range(width):
        while True:
            busy = [row for row in rows if row[c] != 0]
            if len(busy) <= 1:
                break
            pivot = min(busy, key=lambda row: abs(row[c]))
            for row in busy:
                if row is not pivot:
                    q = row[c] // pivot[c]
                    for j in range(width):
                        row[j] -= q * pivot[j]
        if busy:
            rows = [row for row in rows if row is not busy[0]]
            done.append(busy[0] if busy[0][c] > 0 else [-v for v in busy[0]])
    return [tuple(F(v, scale) for v in row) for row in done]


def reduce_vector(basis, v):
    """The representative of v modulo the lattice of an echelon basis."""
    v = list(v)
    for row in basis:
        c = next(j for j in range(len(row)) if row[j] != 0)
        q = (v[c] / row[c]).__floor__()
        if q:
            v = [a - q * b for a, b in zip(v, row)]
    return tuple(v)


def invariants(rows, width):
    """Z^width modulo the rows: (rank, torsion coefficients). Rows are dictionaries column -> integer."""
    rows = [{c: v for c, v in row.items() if v} for row in rows]
    rows = [row for row in rows if row]
    used, torsion = 0, []
    while rows:
        # Smallest entry anywhere, and among those the shortest row: unit pivots are cheap.
        i, c = min(((i, c) for i, row in enumerate(rows) for c in row),
                   key=lambda ic: (abs(rows[ic[0]][ic[1]]), len(rows[ic[0]])))
        pivot = rows[i]
        p = pivot[c]
        clean = True
        for k, row in enumerate(rows):
            if k != i and c in row:
                q = row[c] // p
                for j, v in pivot.items():
                    row[j] = row.get(j, 0) - q * v
                    if row[j] == 0:
                        del row[j]
                clean = clean and c not in row
        if not clean:
            continue
        if all(v % p == 0 for v in pivot.values()):
            used += 1
            if abs(p) > 1:
                torsion.append(abs(p))
            rows = [row for k, row in enumerate(rows) if k != i and row]
        else:  # column operations: subtract multiples of column c (now alone in its row) from the others
            rows[i] = {j: v % p for j, v in pivot.items() if v % p}
            rows[i][c] = p
            # The column operation touches no other row, since column c is zero there. Bring the remainder to the front.
    torsion = normal(torsion)
    return width - used, torsion


def normal(torsion):
    """Invariant factors, each dividing the next."""
    torsion = list(torsion)
    for i in range(len(torsion)):
        for j in range(i + 1, len(torsion)):
            g = gcd(torsion[i], torsion[j])
            torsion[i], torsion[j] = g, torsion[i] * torsion[j] // g
    return tuple(t for t in torsion if t > 1)


class NotCrystallographic(Exception):
    pass


class Group:
    """The group that elements generate: discrete, cocompact, finite linear part, or NotCrystallographic."""

    def __init__(self, dim, generators, gram=None):
        self.dim = dim
        one = identity(dim)
        for g in generators:
            if gram is not None:
                transpose = tuple(zip(*g[0]))
                if matmul(matmul(transpose, gram), g[0]) != gram:
                    raise NotCrystallographic("metric not invariant")
            elif det(g[0]) not in (1, -1):
                raise NotCrystallographic("not an isometry")
        self.reps = {one[0]: one}
        queue = [one]
        kernel = []
        limit = {2: 12, 3: 48}[dim]
        while queue:
            g = queue.pop(0)
            for s in generators:
                h = compose(g, s)
                if h[0] not in self.reps:
                    self.reps[h[0]] = h
                    queue.append(h)
                    if len(self.reps) > limit:
                        raise NotCrystallographic("infinite linear part")
                else:
                    kernel.append(compose(h, inverse(self.reps[h[0]]))[1])
        self.lattice = echelon(kernel)
        if len(self.lattice) < dim:
            raise NotCrystallographic("not cocompact")

    @property
    def covolume(self):
        return abs(det(self.lattice)) / len(self.reps)

    @property
    def orientable(self):
        return all(det(r) > 0 for r in self.reps)

    def __contains__(self, g):
        if g[0] not in self.reps:
            return False
        t = [a - b for a, b in zip(g[1], self.reps[g[0]][1])]
        return not any(reduce_vector(self.lattice, t))

    def torsion(self):
        """A linear part R != 1 of which some element has finite order, or None."""
        for r, g in self.reps.items():
            if r == identity(self.dim)[0]:
                continue
            total, power = None, identity(self.dim)[0]
            while total is None or power != identity(self.dim)[0]:
                total = power if total is None else tuple(
                    tuple(a + b for a, b in zip(x, y)) for x, y in zip(total, power))
                power = matmul(power, r)
            image = (total, (F(0),) * self.dim)
            basis = echelon([apply(image, b) for b in self.lattice])
            if not any(reduce_vector(basis, apply(image, g[1]))):
                return r
        return None

    def homology(self):
        """H1 = G/[G,G] as (rank, torsion)."""
        d, one = self.dim, identity(self.dim)[0]
        index = {r: d + k for k, r in enumerate(self.reps)}

        def coordinates(v):
            c = solve(tuple(zip(*self.lattice)), v)
            assert all(x.denominator == 1 for x in c)
            return [int(x) for x in c]

        relations = [{index[one]: 1}]
        for r, g in self.reps.items():
            for i, b in enumerate(self.lattice):
                row = dict(enumerate(coordinates(apply((r, (F(0),) * d), b))))
                row[i] -= 1
                relations.append(row)
            for s, h in self.reps.items():
                product = compose(g, h)
                row = dict(enumerate(-c for c in coordinates(compose(product, inverse(self.reps[product[0]]))[1])))
                for k, v in ((index[r], 1), (index[s], 1), (index[product[0]], -1)):
                    row[k] = row.get(k, 0) + v
                relations.append(row)
        return invariants(relations, d + len(self.reps))

    def canonical(self, x):
        """(y, h): y = h x, the same y for all points of the orbit of x. The action is free, so h is unique."""
        best = None
        for g in self.reps.values():
            y = apply(g, x)
            z = reduce_vector(self.lattice, y)
            if best is None or z < best[0]:
                best = z, (g[0], tuple(a + b - c for a, b, c in zip(g[1], z, y)))
        return best

    def coset_representatives(self, sub):
        """One element of each right coset (sub)g."""
        found, queue = [identity(self.dim)], [identity(self.dim)]
        steps = [translation(*b) for b in self.lattice] + list(self.reps.values())
        while queue:
            g = queue.pop(0)
            for s in steps:
                h = compose(g, s)
                if not any(compose(h, inverse(k)) in sub for k in found):
                    found.append(h)
                    queue.append(h)
        assert len(found) * self.covolume == sub.covolume
        return found


# ---------------------------------------------------------------- the catalogue: names, orientable, |holonomy|, H1, generators

T3 = ["1 0 0 1 0 1 0 0 0 0 1 0", "1 0 0 0 0 1 0 1 0 0 1 0", "1 0 0 0 0 1 0 0 0 0 1 1"]
SQUARE, CUBE, HEXAGONAL = "1 0 1", "1 0 0 1 0 1", "1 -1/2 0 1 0 1"
CATALOGUE = [
    ("torus p1", 2, True, 1, (2, ()), ["1 0 1 0 1 0", "1 0 0 0 1 1"], SQUARE),
    ("klein-bottle pg", 2, False, 2, (1, (2,)), ["1 0 1 0 1 0", "-1 0 0 0 1 1/2"], SQUARE),
    ("torocosm G1 P1 3-torus", 3, True, 1, (3, ()), T3, CUBE),
    ("dicosm G2 P21", 3, True, 2, (1, (2, 2)), T3[:2] + ["-1 0 0 0 0 -1 0 0 0 0 1 1/2"], CUBE),
    ("tricosm G3 P31", 3, True, 3, (1, (3,)), T3[:1] + ["0 -1 0 0 1 -1 0 0 0 0 1 1/3"], HEXAGONAL),
    ("tetracosm G4 P41", 3, True, 4, (1, (2,)), T3[:1] + ["0 -1 0 0 1 0 0 0 0 0 1 1/4"], CUBE),
    ("hexacosm G5 P61", 3, True, 6, (1, ()), T3[:1] + ["1 -1 0 0 1 0 0 0 0 0 1 1/6"], HEXAGONAL),
    ("didicosm G6 P212121 hantzsche-wendt", 3, True, 4, (0, (4, 4)),
     ["1 0 0 1/2 0 -1 0 1/2 0 0 -1 0", "-1 0 0 0 0 1 0 1/2 0 0 -1 1/2"], CUBE),
    ("first-amphicosm B1 Pc", 3, False, 2, (2, (2,)), T3[:2] + ["1 0 0 0 0 -1 0 0 0 0 1 1/2"], CUBE),
    ("second-amphicosm B2 Cc", 3, False, 2, (2, ()), T3[:1] + ["0 1 0 0 1 0 0 0 0 0 1 1/2"], CUBE),
    ("first-amphidicosm B3 Pca21", 3, False, 4, (1, (2, 2)),
     ["-1 0 0 0 0 -1 0 0 0 0 1 1/2", "1 0 0 1/2 0 -1 0 0 0 0 1 0", T3[1]], CUBE),
    ("second-amphidicosm B4 Pna21", 3, False, 4, (1, (4,)),
     ["-1 0 0 0 0 -1 0 0 0 0 1 1/2", "1 0 0 1/2 0 -1 0 1/2 0 0 1 0"], CUBE),
]
MIRRORS = {"P32": ("P31", "1/3"), "P43": ("P41", "1/4"), "P65": ("P61", "1/6")}


def manifold(name):
    """(canonical name, dimension, generators, metric) of a name or alias."""
    base, pitch = MIRRORS.get(name, (name, None))
    for names, dim, _, _, _, generators, metric in CATALOGUE:
        if base in names.split():
            if pitch:
                generators = [g.replace(pitch, "-" + pitch) for g in generators]
            return names.split()[0], dim, generators, metric
    raise KeyError(name)


def recognise(group):
    for names, dim, orientable, order, h1, _, _ in CATALOGUE:
        if (dim, orientable, order, h1) == (group.dim, group.orientable, len(group.reps), group.homology()):
            return names.split()[0]
    raise AssertionError("no closed flat manifold")


# ---------------------------------------------------------------- files


def number(word):
    if re.fullmatch(r"[+-]?[0-9]+(/[0-9]+)?", word):
        return F(word)
    m = re.fullmatch(r"([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)(?:p([+-]?[0-9]+))?", word.lower())
    if m:
        digits = m[2] + m[3]
        value = F(int(digits, 16)) * F(2) ** (int(m[4] or 0) - 4 * len(m[3]))
        return -value if m[1] == "-" else value
    return F(word)


class Instance:
    def __init__(self, dim, points, manifold=None, generators=None, metric=None, note=None):
        self.dim, self.manifold, self.generators, self.metric, self.note = dim, manifold, generators, metric, note
        self.points = [tuple(number(w) for w in p.split()) if isinstance(p, str) else tuple(map(F, p)) for p in points]

    def texts(self):
        return manifold(self.manifold)[2] if self.generators is None else self.generators

    def elements(self):
        return [element(self.dim, g) for g in self.texts()]

    def gram(self):
        text = self.metric
        if text is None:
            text = manifold(self.manifold)[3] if self.generators is None else {2: SQUARE, 3: CUBE}[self.dim]
        values = iter([number(w) for w in text.split()])
        m = [[None] * self.dim for _ in range(self.dim)]
        for i in range(self.dim):
            for j in range(i, self.dim):
                m[i][j] = m[j][i] = next(values)
        return tuple(map(tuple, m))

    def group(self):
        return Group(self.dim, self.elements(), self.gram())

    def text(self):
        out = ["# " + line for line in (self.note or "").splitlines()] + ["flatdt-instance 1", f"dimension {self.dim}"]
        if self.manifold is not None:
            out.append("manifold " + self.manifold)
        if self.generators is not None:
            out += [f"generators {len(self.generators)}"] + ["  " + g for g in self.generators]
        if self.metric is not None:
            out.append("metric " + self.metric)
        out += [f"points {len(self.points)}"] + ["  " + " ".join(map(str, p)) for p in self.points]
        return "\n".join(out) + "\n"


def words(element):
    return " ".join(str(v) for row, s in zip(*element) for v in (*row, s))


class Triangulation:
    """cells: lists of (point index, group element). subgroup: elements as texts, or None for H = G."""

    def __init__(self, cells, subgroup=None, note=None, elements=None):
        self.cells, self.subgroup, self.note, self.listed = cells, subgroup, note, list(elements or [])

    def copy(self):
        return Triangulation([list(c) for c in self.cells], self.subgroup, self.note, self.listed)

    def text(self, body_only=False):
        index = {g: k for k, g in reversed(list(enumerate(self.listed)))}
        elements = list(self.listed)
        rows = []
        for cell in self.cells:
            for _, g in cell:
                if g not in index:
                    index[g] = len(elements)
                    elements.append(g)
            rows.append("  " + "  ".join(f"{i} {index[g]}" for i, g in cell))
        out = ["# " + line for line in (self.note or "").splitlines()] + ["flatdt-triangulation 1"]
        if self.subgroup is not None:
            out += [f"subgroup {len(self.subgroup)}"] + ["  " + g for g in self.subgroup]
        out += [f"elements {len(elements)}"] + ["  " + words(g) for g in elements] + [f"cells {len(rows)}"] + rows
        return "\n".join(out) + "\n"


class Reader:
    def __init__(self, text):
        self.words = re.sub(r"#[^\n]*", " ", text).split()
        self.at = 0

    def next(self, n=None):
        self.at += n or 1
        return self.words[self.at - 1] if n is None else self.words[self.at - n:self.at]

    def section(self, name):
        if self.words[self.at:self.at + 1] != [name]:
            return None
        self.at += 2
        return int(self.words[self.at - 1])


def read_instance(path):
    r = Reader(open(path, encoding="latin-1").read())
    assert r.next(2) == ["flatdt-instance", "1"] and r.next() == "dimension"
    d = int(r.next())
    name = r.next(2)[1] if r.words[r.at] == "manifold" else None
    n = r.section("generators")
    generators = None if n is None else [" ".join(r.next(d * (d + 1))) for _ in range(n)]
    metric = " ".join(r.next(1 + d * (d + 1) // 2)[1:]) if r.words[r.at] == "metric" else None
    n = r.section("points")
    return Instance(d, [" ".join(r.next(d)) for _ in range(n)], name, generators, metric)


def read_triangulation(path, dim):
    r = Reader(open(path, encoding="latin-1").read())
    assert r.next(2) == ["flatdt-triangulation", "1"]
    n = r.section("subgroup")
    size = dim * (dim + 1)
    subgroup = None if n is None else [" ".join(r.next(size)) for _ in range(n)]
    n = r.section("elements")
    elements = [element(dim, r.next(size) and " ".join(r.words[r.at - size:r.at])) for _ in range(n)]
    n = r.section("cells")
    cells = []
    for _ in range(n):
        flat = list(map(int, r.next(2 * (dim + 1))))
        cells.append([(flat[2 * k], elements[flat[2 * k + 1]]) for k in range(dim + 1)])
    return Triangulation(cells, subgroup, elements=elements)


def volume(points):
    base = points[0]
    return det([tuple(a - b for a, b in zip(p, base)) for p in points[1:]]) / factorial(len(base))


def permutation_sign(order):
    return -1 if sum(a > b for a, b in itertools.combinations(order, 2)) % 2 else 1
