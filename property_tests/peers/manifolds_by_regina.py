#!/usr/bin/env python3
"""Regina recognises the manifolds: manifolds_by_regina.py FLATDT [--valid FOLDER]

Glues the cells of triangulations by their facets modulo the group and asks Regina (Debian package regina-normal, made
with 7.3) which manifold that is: closed, connected, orientable or not, first homology, and its name in Regina's census.
- Point sets triangulated by FLATDT on the ten closed flat 3-manifolds, both hands: the quotient by the whole group, also
  where the file describes a covering space, since Regina needs no simplicial complex. On the two surfaces: Euler number,
  orientability, homology.
- The triangulations of FOLDER (corpora/valid), each of the space that its file names.
The gluing uses ../corpora/flatgeom.py: Fractions, no code of ref/ or checker/.

Exit code 0: all recognised; 1: some not; 77: Regina is not installed.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "corpora"))
import flatgeom  # noqa: E402

# Names in Regina's census. A closed Seifert manifold is flat iff its base orbifold has Euler number 0 and its own Euler
# number is 0 (Scott, The geometries of 3-manifolds, 1983): the sums of the fractions below are 0. The two amphicosms are
# the torus bundles with a reflection as monodromy, which has two classes in GL(2,Z); the base of the first amphidicosm
# is a disc with reflecting boundary. Bundles and bases as in Conway and Rossetti, Describing the platycosms, 2003.
CENSUS = {
    "torocosm": "T x S1",
    "dicosm": "KB/n2 x~ S1",                              # over S2(2,2,2,2) in another fibration
    "tricosm": "SFS [S2: (3,1) (3,1) (3,-2)]",
    "tetracosm": "SFS [S2: (2,1) (4,1) (4,-3)]",
    "hexacosm": "SFS [S2: (2,1) (3,1) (6,-5)]",
    "didicosm": "SFS [RP2/n2: (2,1) (2,-1)]",
    "first-amphicosm": "T x I / [ 1,0 | 0,-1 ]",
    "second-amphicosm": "T x I / [ 0,1 | 1,0 ]",
    "first-amphidicosm": "SFS [D_: (2,1) (2,1)]",
    "second-amphidicosm": "SFS [RP2: (2,1) (2,1)]",
}
MOST_TO_SEARCH = 10  # tetrahedra; the search is exponential
MOST_CELLS = 470  # of files that are recognised: Regina's time grows quickly


def glued(points, triangulation, space):
    """The gluings of the cells modulo `space`, from cells modulo it or a subgroup: (number of cells, gluings). A gluing
    is (cell, facet, other cell, images of the vertices); facet i is opposite to vertex i."""
    chosen = {}
    for cell in triangulation.cells:
        lifts = [flatgeom.apply(g, points[i]) for i, g in cell]
        chosen.setdefault(key(space, lifts)[0], []).append(lifts)
    if len({len(lifts) for lifts in chosen.values()}) != 1:
        raise ValueError("the cells are not invariant under the group")
    cells = [lifts[0] for lifts in chosen.values()]
    facets = {}
    for c, lifts in enumerate(cells):
        for i in range(len(lifts)):
            name, mover = key(space, lifts[:i] + lifts[i + 1:])
            facets.setdefault(name, []).append((c, i, [flatgeom.apply(mover, x) for x in lifts]))
    gluings = []
    for two in facets.values():
        if len(two) != 2:
            raise ValueError("a facet is not in two cells")
        (c, i, here), (e, j, there) = two
        gluings.append((c, i, e, [j if k == i else there.index(x) for k, x in enumerate(here)]))
    return len(cells), gluings


def key(space, points):
    """A name of the face modulo the group, and the element that takes its barycentre to the canonical place."""
    barycentre = tuple(sum(x) / len(points) for x in zip(*points))
    mover = space.canonical(barycentre)[1]
    return tuple(sorted(flatgeom.apply(mover, x) for x in points)), mover


def homology_of(group):
    """(rank, invariant factors) of Regina's AbelianGroup."""
    return group.rank(), tuple(int(group.invariantFactor(i).stringValue()) for i in range(group.countInvariantFactors()))


def recognised(regina, dim, size, gluings, expected):
    """Regina's name, or an exception that says what differs from the catalogue's entry."""
    name, _, orientable, _, h1 = expected[:5]
    name = name.split()[0]
    if dim == 2:
        t = regina.Triangulation2.fromGluings(size, [(c, i, e, regina.Perm3(*p)) for c, i, e, p in gluings])
        facts = (t.isConnected() and t.isClosed() and t.eulerChar() == 0, t.isOrientable(), homology_of(t.homology()))
        if facts != (True, orientable, h1):
            raise ValueError(f"closed with Euler number 0, orientable, H1: {facts} instead of {(True, orientable, h1)}")
        return "torus" if orientable else "Klein bottle"
    t = regina.Triangulation3.fromGluings(size, [(c, i, e, regina.Perm4(*p)) for c, i, e, p in gluings])
    facts = (t.isValid() and t.isClosed() and t.isConnected() and t.eulerCharManifold() == 0, t.isOrientable())
    if facts != (True, orientable):
        raise ValueError(f"closed manifold, orientable: {facts} instead of {(True, orientable)}")
    small = regina.Triangulation3(t)
    small.intelligentSimplify()
    found = homology_of(small.homology())
    if found != h1:
        raise ValueError(f"H1 {found} instead of {h1}")
    names = census(regina, small)
    # Simplification can end in a triangulation that is not minimal, and so in no census: then search further round it.
    for height in (1, 2):
        if not names and small.size() <= MOST_TO_SEARCH:
            small.simplifyExhaustive(height)
            names = census(regina, small)
    if names != [CENSUS[name]]:
        raise ValueError(f"census: {names} instead of {CENSUS[name]!r}")
    return names[0]


def census(regina, t):
    return sorted({hit.name().split(" : ")[0].strip() for hit in regina.Census.lookup(t.isoSig())})


def triangulations(flatdt, folder, valid):
    """(what, instance, triangulation, group of the space to recognise) of all that is recognised."""
    jobs = []
    for names, *_ in flatgeom.CATALOGUE:
        for family, points in (("uniform", 1), ("grid", 2), ("skew-basis", 3)):
            jobs.append((names.split()[0], family, points))
    jobs += [(hand, "uniform", 2) for hand in ("P32", "P43", "P65")]
    for seed, (manifold, family, count) in enumerate(jobs):
        stem = folder / f"{manifold}-{family}"
        instance, triangulation = stem.with_suffix(".instance"), stem.with_suffix(".triangulation")
        subprocess.run([flatdt, "generate", "--manifold", manifold, "--points", str(count), "--family", family, "--seed",
                        str(seed), "-o", instance], check=True)
        subprocess.run([flatdt, "triangulate", "--quiet", instance, "-o", triangulation], check=True)
        read = flatgeom.read_instance(instance)
        name = flatgeom.manifold(manifold)[0]
        yield f"{manifold}, {count} {family}", read, flatgeom.read_triangulation(triangulation, read.dim), read.group(), name
    for path in sorted(valid.glob("*.triangulation")) if valid else []:
        read = flatgeom.read_instance(path.with_suffix(".instance"))
        triangulation = flatgeom.read_triangulation(path, read.dim)
        if len(triangulation.cells) > MOST_CELLS:
            continue
        space = read.group()
        if triangulation.subgroup is not None:
            space = flatgeom.Group(read.dim, [flatgeom.element(read.dim, g) for g in triangulation.subgroup], read.gram())
        yield path.stem, read, triangulation, space, flatgeom.recognise(space)


def main():
    parser = argparse.ArgumentParser(description="Regina recognises the manifolds of triangulations.")
    parser.add_argument("flatdt")
    parser.add_argument("--valid", type=pathlib.Path)
    options = parser.parse_args()
    try:
        import regina
    except ImportError:
        # Debian's module is for Debian's interpreter, which need not be the first on the path.
        debian = "/usr/bin/python3"
        if os.path.exists(debian) and not os.path.samefile(debian, sys.executable) and "FLATDT_PEER" not in os.environ:
            os.environ["FLATDT_PEER"] = "regina"
            os.execv(debian, [debian, *sys.argv])
        print("Regina is not installed (Debian package regina-normal): manifolds are not recognised")
        return 77
    entries = {entry[0].split()[0]: entry for entry in flatgeom.CATALOGUE}
    print(f"{'triangulation':<36} {'cells':>6}  {'quotient':>8}  {'manifold':<19} {'Regina says':<30} {'seconds':>8}")
    failures = count = 0
    with tempfile.TemporaryDirectory(prefix="flatdt-peers-") as folder:
        for what, instance, triangulation, space, name in triangulations(options.flatdt, pathlib.Path(folder),
                                                                         options.valid):
            begin = time.monotonic()
            size = 0
            try:
                size, gluings = glued(instance.points, triangulation, space)
                says = recognised(regina, instance.dim, size, gluings, entries[name])
            except (ValueError, KeyError) as wrong:
                says, failures = f"WRONG: {wrong}", failures + 1
            count += 1
            print(f"{what:<36} {len(triangulation.cells):>6}  {size:>8}  {name:<19} {says:<30} "
                  f"{time.monotonic() - begin:>8.2f}", flush=True)
    print(f"Regina {regina.versionString()}: {count - failures} of {count} recognised")
    return 0 if failures == 0 and count else 1


if __name__ == "__main__":
    sys.exit(main())
