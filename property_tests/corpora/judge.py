"""The status of every condition of FORMAT.md, computed as the table states it and nothing more.

Quadratic where the definition is. Used to make the records of corpora/ (make_corpus.py), together with the statuses
claimed there by hand: where the two differ no record is written.
"""

import itertools
from collections import defaultdict

from flatgeom import (Group, NotCrystallographic, apply, element, invariants, manifold, permutation_sign, recognise, solve,
                      volume)

CONDITIONS = """group.crystallographic group.torsion-free group.name subgroup.member vertices.complete cells.nondegenerate
facets.paired facets.opposite volume.exact delaunay.empty simplices.injective skeleton.no-loop skeleton.no-2-cycle
complex.intersection links.spheres topology.connected topology.euler topology.orientable topology.homology""".split()


def components(nodes, edges):
    parent = {n: n for n in nodes}

    def find(n):
        while parent[n] != n:
            parent[n] = parent[parent[n]]
            n = parent[n]
        return n

    for a, b in edges:
        parent[find(a)] = find(b)
    return len({find(n) for n in parent})


def is_circle(edges):
    degree = defaultdict(int)
    for e in edges:
        for v in e:
            degree[v] += 1
    return bool(edges) and all(d == 2 for d in degree.values()) and components(degree, [tuple(e) for e in edges]) == 1


def is_sphere(faces, dim):
    """Whether sets of dim points each are the top cells of a (dim-1)-sphere."""
    if dim == 2:
        return is_circle(faces)
    count, around, vertices = defaultdict(int), defaultdict(list), set()
    for f in faces:
        vertices |= f
        for v in f:
            count[f - {v}] += 1
            around[v].append(f - {v})
    return (bool(faces) and all(c == 2 for c in count.values()) and all(is_circle(c) for c in around.values())
            and components(vertices, [tuple(e) for e in count]) == 1 and len(vertices) - len(count) + len(faces) == 2)


class Judge:
    def __init__(self, instance, triangulation):
        self.status = {name: "skipped" for name in CONDITIONS}
        self.i, self.t = instance, triangulation
        if self.groups():
            self.cells()

    def set(self, name, good):
        self.status[name] = "holds" if good else "fails"
        return good

    def holds(self, *names):
        return all(self.status[n] == "holds" for n in names)

    def groups(self):
        i = self.i
        try:
            self.g = i.group()
        except NotCrystallographic:
            return self.set("group.crystallographic", False)
        self.set("group.crystallographic", True)
        if not self.set("group.torsion-free", self.g.torsion() is None):
            return False
        if i.manifold is not None and not self.set("group.name", recognise(self.g) == manifold(i.manifold)[0]):
            return False
        self.h = self.g
        used = self.t.listed + [g for cell in self.t.cells for _, g in cell]
        good = all(g in self.g for g in dict.fromkeys(used))
        if self.t.subgroup is not None:
            generators = [element(i.dim, g) for g in self.t.subgroup]
            good = good and all(g in self.g for g in generators)
            if good:
                try:
                    self.h = Group(i.dim, generators)
                except NotCrystallographic:
                    good = False
        return self.set("subgroup.member", good)

    def cells(self):
        d, h, gram = self.i.dim, self.h, self.i.gram()
        lifted = [[apply(g, self.i.points[i]) for i, g in cell] for cell in self.t.cells]
        assert all(len(set(c)) == d + 1 for c in lifted), "a vertex twice in a cell: not for this corpus"
        self.cache = {}
        # Faces of all dimensions: canonical lift (sorted tuple of points) -> occurrences (cell, vertex indices, h).
        faces = [defaultdict(list) for _ in range(d + 1)]
        for c, cell in enumerate(lifted):
            for k in range(d + 1):
                for chosen in itertools.combinations(range(d + 1), k + 1):
                    key, move = self.key([cell[j] for j in chosen])
                    faces[k][key].append((c, chosen, move))
        orbit = lambda x: self.canonical(x)[0]

        distinct = len({self.g.canonical(p)[0] for p in self.i.points})
        self.set("vertices.complete", len(faces[0]) >= distinct * h.covolume / self.g.covolume)
        volumes = [volume(c) for c in lifted]
        self.set("cells.nondegenerate", all(volumes))
        paired = [o for o in faces[d - 1].values() if len(o) == 2]
        self.set("facets.paired", len(paired) == len(faces[d - 1]))

        opposite, empty = True, True
        for key, pair in ((k, o) for k, o in faces[d - 1].items() if len(o) == 2):
            sides = []
            for c, chosen, move in pair:
                j = next(j for j in range(d + 1) if j not in chosen)
                sides.append((c, apply(move, lifted[c][j])))
            if not all(volumes[c] for c, _ in sides):
                continue
            if (volume(list(key) + [sides[0][1]]) > 0) == (volume(list(key) + [sides[1][1]]) > 0):
                opposite = False
                continue
            centre, radius = self.ball(list(key) + [sides[0][1]], gram)
            empty = empty and self.square(gram, sides[1][1], centre) >= radius
        self.set("facets.opposite", opposite)
        self.set("volume.exact", sum(map(abs, volumes)) == h.covolume)
        if not empty:
            self.set("delaunay.empty", False)
        elif self.holds("vertices.complete", "cells.nondegenerate", "facets.paired", "facets.opposite", "volume.exact"):
            self.set("delaunay.empty", True)

        self.set("simplices.injective", all(len({orbit(x) for x in c}) == d + 1 for c in lifted))
        ends = [tuple(sorted(map(orbit, e))) for e in faces[1]]
        self.set("skeleton.no-loop", all(a != b for a, b in ends))
        self.set("skeleton.no-2-cycle", len(set(ends)) == len(ends))
        if self.holds("cells.nondegenerate", "facets.paired", "facets.opposite", "volume.exact"):
            sets = [frozenset(map(orbit, f)) for k in range(d + 1) for f in faces[k]]
            self.set("complex.intersection", len(set(sets)) == len(sets) and self.holds("simplices.injective"))
        if not self.holds("facets.paired"):
            return

        if self.holds("cells.nondegenerate"):
            links = defaultdict(set)
            for c, cell in enumerate(lifted):
                for j, x in enumerate(cell):
                    y, move = self.canonical(x)
                    links[y].add(frozenset(apply(move, cell[k]) for k in range(d + 1) if k != j))
            self.set("links.spheres", all(is_sphere(link, d) for link in links.values()))
        gluings = [(pair[0], pair[1], key) for key, pair in faces[d - 1].items()]
        count = components(range(len(lifted)), [(a[0], b[0]) for a, b, _ in gluings])
        self.set("topology.connected", count <= 1)  # without cells no two cells are unconnected
        self.set("topology.euler", sum((-1) ** k * len(faces[k]) for k in range(d + 1)) == 0)

        # Orientable iff the double cover with sheets (cell, +-1), glued so that induced orientations cancel, splits.
        sheets = [(c, s) for c in range(len(lifted)) for s in (1, -1)]
        seams = []
        for a, b, key in gluings:
            product = self.induced(lifted, a, key) * self.induced(lifted, b, key)
            seams += [((a[0], s), (b[0], -product * s)) for s in (1, -1)]
        parts = self.parts(sheets, seams)
        self.set("topology.orientable", h.orientable == all(parts[c, 1] != parts[c, -1] for c in range(len(lifted))))

        # H1 = free group on edges, abelianised, modulo triangles and a spanning forest.
        edges = {key: n for n, key in enumerate(faces[1])}
        parent, forest = {x[0]: x[0] for x in faces[0]}, []
        for key, n in edges.items():
            a, b = (self.root(parent, orbit(x)) for x in key)
            if a != b:
                parent[a] = b
                forest.append({n: 1})
        rows = []
        for key in faces[2]:
            row = defaultdict(int)
            for i, j, sign in ((0, 1, 1), (1, 2, 1), (0, 2, -1)):
                image, move = self.key([key[i], key[j]])
                row[edges[image]] += sign if image[0] == apply(move, key[i]) else -sign
            rows.append(dict(row))
        self.set("topology.homology", invariants(forest + rows, len(edges)) == h.homology())

    def canonical(self, x):
        if x not in self.cache:
            self.cache[x] = self.h.canonical(x)
        return self.cache[x]

    def key(self, points):
        """The canonical lift of a face: over its vertices, move one to its canonical place; the least sorted result."""
        best = None
        for x in points:
            move = self.canonical(x)[1]
            moved = tuple(sorted(apply(move, y) for y in points))
            if best is None or moved < best[0]:
                best = moved, move
        return best

    @staticmethod
    def induced(lifted, occurrence, key):
        c, chosen, move = occurrence
        j = next(j for j in range(len(lifted[c])) if j not in chosen)
        return (-1) ** j * permutation_sign([key.index(apply(move, lifted[c][k])) for k in chosen])

    @staticmethod
    def root(parent, x):
        while parent[x] != x:
            x = parent[x]
        return x

    def parts(self, nodes, edges):
        parent = {n: n for n in nodes}
        for a, b in edges:
            parent[self.root(parent, a)] = self.root(parent, b)
        return {n: self.root(parent, n) for n in nodes}

    @staticmethod
    def square(gram, x, y):
        v = [a - b for a, b in zip(x, y)]
        return sum(v[i] * gram[i][j] * v[j] for i in range(len(v)) for j in range(len(v)))

    def ball(self, points, gram):
        base = points[0]
        rows, right = [], []
        for p in points[1:]:
            v = [a - b for a, b in zip(p, base)]
            rows.append([2 * sum(v[i] * gram[i][j] for i in range(len(v))) for j in range(len(v))])
            right.append(self.square(gram, p, base))
        centre = tuple(a + b for a, b in zip(solve(rows, right), base))
        return centre, self.square(gram, base, centre)

    def verdict(self):
        if any(s == "fails" and n.startswith("group.") for n, s in self.status.items()):
            return "MALFORMED", 2
        return ("REFUTED", 1) if "fails" in self.status.values() else ("VERIFIED", 0)
