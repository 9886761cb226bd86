"""Building blocks of the corpus: lattice triangulations, covers, flips, edits. Exact and deterministic."""

import itertools
import random

from flatgeom import (Group, Instance, Triangulation, apply, compose, element, identity, inverse, reduce_vector,
                      translation, volume, F)


class Drawing:
    """Cells given by the places of their vertices in E^d, for instances whose group holds the translations needed."""

    def __init__(self, instance, subgroup=None):
        self.instance, self.group, self.tri = instance, instance.group(), Triangulation([], subgroup)
        self.known = {reduce_vector(self.group.lattice, p): i for i, p in reversed(list(enumerate(instance.points)))}

    def vertex(self, x):
        for g in self.group.reps.values():  # a point of the orbit of x under the point group that is p + l
            y = apply(inverse(g), x)
            i = self.known.get(reduce_vector(self.group.lattice, y))
            if i is not None:
                p = self.instance.points[i]
                return i, compose(g, translation(*(a - b for a, b in zip(y, p))))
        raise KeyError(x)

    def add(self, *cells):
        for cell in cells:
            self.tri.cells.append([self.vertex(tuple(map(F, x))) for x in cell])
        return self


def kuhn(corner, flips=()):
    """The Kuhn triangulation of the unit cube at corner, mirrored in the coordinates `flips`."""
    d = len(corner)
    for order in itertools.permutations(range(d)):
        cell, x = [], [0] * d
        for step in (None, *order):
            if step is not None:
                x[step] = 1
            cell.append(tuple(c + (1 - v if k in flips else v) for k, (c, v) in enumerate(zip(corner, x))))
        yield cell


def grid(*sizes):
    return itertools.product(*map(range, sizes))


def five(corner, parity):
    """Five tetrahedra of the unit cube at corner; the central one on the corners whose coordinate sum has that parity."""
    corners = [tuple(c + v for c, v in zip(corner, x)) for x in grid(2, 2, 2)]
    centre = [x for x in corners if sum(x) % 2 == parity]
    yield centre
    for x in corners:
        if x not in centre:
            yield [x] + [y for y in centre if sum(a != b for a, b in zip(x, y)) == 1]


def multiples(*sizes):
    """The subgroup that sizes[i] * e_i generate, as texts."""
    d = len(sizes)
    return [" ".join(str(int(i == j)) if j < d else str(sizes[k] if i == k else 0) for i in range(d) for j in range(d + 1))
            for k in range(d)]


def lift(instance, cell):
    return [apply(g, instance.points[i]) for i, g in cell]


def moved(h, cell):
    return [(i, compose(h, g)) for i, g in cell]


class Faces:
    """Facets (or edges) of a triangulation modulo H: canonical lift -> [(cell, vertex indices, h)]."""

    def __init__(self, instance, tri, size):
        self.h = instance.group() if tri.subgroup is None else Group(
            instance.dim, [element(instance.dim, g) for g in tri.subgroup])
        self.lifted = [lift(instance, c) for c in tri.cells]
        self.cache, self.at = {}, {}
        for c, cell in enumerate(self.lifted):
            for chosen in itertools.combinations(range(instance.dim + 1), size):
                key, h = self.key([cell[j] for j in chosen])
                self.at.setdefault(key, []).append((c, chosen, h))

    def key(self, points):
        best = None
        for x in points:
            if x not in self.cache:
                self.cache[x] = self.h.canonical(x)[1]
            h = self.cache[x]
            image = tuple(sorted(apply(h, y) for y in points))
            if best is None or image < best[0]:
                best = image, h
        return best


def cover(instance, tri, subgroup):
    """The same G-invariant triangulation of E^d, modulo another subgroup (None: G itself)."""
    whole = Triangulation(tri.cells)
    faces = Faces(instance, whole, instance.dim + 1)
    cells = [tri.cells[occurrences[0][0]] for occurrences in faces.at.values()]
    if subgroup is None:
        return Triangulation(cells)
    sub = Group(instance.dim, [element(instance.dim, g) for g in subgroup])
    return Triangulation([moved(g, c) for g in instance.group().coset_representatives(sub) for c in cells], subgroup)


def flips(instance, tri, kind):
    """Every triangulation that one flip makes: '2-2', '2-3' or '3-2' (strictly convex position)."""
    d = instance.dim
    faces = Faces(instance, tri, 2 if kind == "3-2" else d)
    for occurrences in faces.at.values():
        if len(occurrences) != (3 if kind == "3-2" else 2) or len({c for c, _, _ in occurrences}) != len(occurrences):
            continue
        cells = [moved(h, tri.cells[c]) for c, _, h in occurrences]
        shared = [v for v in cells[0] if apply(v[1], instance.points[v[0]]) in
                  {apply(moved(h, [tri.cells[c][j]])[0][1], instance.points[tri.cells[c][j][0]])
                   for c, chosen, h in occurrences[:1] for j in chosen}]
        place = lambda v: apply(v[1], instance.points[v[0]])
        inner = {place(v) for v in shared}
        others = {}
        for cell in cells:
            for v in cell:
                if place(v) not in inner:
                    others.setdefault(place(v), v)
        others = list(others.values())
        if kind == "3-2":
            if len(others) != 3:
                continue
            facet, (a, b) = others, shared
        else:
            facet, (a, b) = shared, others
        # The segment ab crosses the inside of the facet.
        ring = [(facet[k], facet[(k + 1) % d]) for k in range(d)] if d == 3 else [(v,) for v in facet]
        signs = [volume([place(v) for v in (a, b, *r)]) for r in ring]
        crossing = (all(s > 0 for s in signs) or all(s < 0 for s in signs)) if d == 3 else signs[0] * signs[1] < 0
        sides = [volume([place(v) for v in (*facet, x)]) for x in (a, b)]
        if not crossing or sides[0] * sides[1] >= 0:
            continue
        gone = {c for c, _, _ in occurrences}
        new = [[*facet, a], [*facet, b]] if kind == "3-2" else [[a, b, *r] for r in ring]
        yield Triangulation([c for k, c in enumerate(tri.cells) if k not in gone] + new, tri.subgroup)


def shuffled(instance, tri, seed):
    """Other lifts, other order of vertices and cells, elements listed in another order, twice, and some unused."""
    rng = random.Random(seed)
    group = instance.group() if tri.subgroup is None else Group(
        instance.dim, [element(instance.dim, g) for g in tri.subgroup])
    steps = list(group.reps.values()) + [translation(*b) for b in group.lattice]
    steps += [inverse(g) for g in steps]
    cells = []
    for cell in tri.cells:
        h = identity(instance.dim)
        for _ in range(rng.randrange(4)):
            h = compose(h, rng.choice(steps))
        cell = moved(h, cell)
        rng.shuffle(cell)
        cells.append(cell)
    rng.shuffle(cells)
    elements = list(dict.fromkeys(g for c in cells for _, g in c)) + steps
    rng.shuffle(elements)
    return Triangulation(cells, tri.subgroup, elements=elements + elements[:5])


def kronecker(dim, n, box=None):
    """n points of a low-discrepancy sequence, with denominator 997."""
    steps = {2: (753, 569), 3: (817, 669, 548)}[dim]
    box = box or (1,) * dim
    return [tuple(F((k + 1) * s % 997, 997) * b for s, b in zip(steps, box)) for k in range(n)]
