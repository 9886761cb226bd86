#!/usr/bin/env python3
"""Makes first inputs for every fuzz target from the corpora and from generated instances.

Usage: make_seeds.py BUILD OUTPUT
BUILD is a build without an engine (the runners encode); OUTPUT gets a folder for each target, and origins.tsv, which
says what each was made of. `scripts/fuzz --minimise` then picks a set cover of them and of what campaigns found.
"""
import fractions
import hashlib
import itertools
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
CORPORA = ROOT / "corpora"
LARGEST = 4000  # bytes of a text taken as it is
LARGEST_STREAM = 6000

MANIFOLDS = {
    2: ["torus", "klein-bottle"],
    3: ["torocosm", "dicosm", "P31", "P32", "P41", "P43", "P61", "P65", "didicosm", "first-amphicosm",
        "second-amphicosm", "first-amphidicosm", "second-amphidicosm"],
}
FAMILIES = ["uniform", "cospherical", "single-orbit"]

COMMANDS = [
    "flatdt\nmanifolds\n--json", "flatdt\nmanifolds", "flatdt\ninfo\ni", "flatdt\ninfo\ni\n--json",
    "flatdt\ngenerate\n--manifold\ndidicosm\n--points\n3\n--family\ncospherical\n--seed\n1\n-o\nout",
    "flatdt\ngenerate\n--family\nlist", "flatdt\ngenerate\n--manifold\nP32\n--points\n2\n--metric\nrandom",
    "flatdt\ntriangulate\ni", "flatdt\ntriangulate\ni\n-o\nout\n--json-summary\ns\n-q\n--order\n5",
    "flatdt\ntriangulate\ni\n--sheets\ntheorem10", "flatdt\ntriangulate\ni\n--max-sheets\n1",
    "flatdt\nimport\ni", "flatdt\nimport\n-\n--coincident\nmerge\n--altloc\nall",
    "flatdt\ndraw\ni\nt", "flatdt\ndraw\ni\nt\n-o\nout\n--two-cycle\n--violation", "flatdt\ndraw\n-\n-",
    "flatdt\n--help", "flatdt\n--version", "flatdt\ntriangulate\n--help", "flatdt", "flatdt\nnothing",
    "flatdt-check\ni\nt", "flatdt-check\ni\nt\n--json", "flatdt-check\ni\n-", "flatdt-check\n-\n-", "flatdt-check\nt\ni",
    "flatdt-check\n--help", "flatdt-check\n--version", "flatdt-check", "flatdt-check\nmissing\nt\n--json",
    "flatdt-check\ni\nt\n--jobs\n2", "flatdt-check\n--from\ncgal-p2t2\nt", "flatdt-check\n--from\ncgal-p3t3\n-\n--json",
    "flatdt-check\n--serve", "flatdt-check\n--serve\n--max-bytes\n99\n--max-seconds\n7", "flatdt-check\n--serve\ni",
    "flatdt\ndraw\ni\nt\n--format\nhtml\n--copies\n1", "flatdt\ndraw\ni\nt\n--verdict\ni\n--condition\nvolume.exact",
    "flatdt\ntriangulate\ni\n--engine\ncovering\n--smallest-cover",
    "flatdt-campaign", "flatdt-campaign\n--help", "flatdt-campaign\n--family\nlist", "flatdt-campaign\n--version",
    "flatdt-campaign\n--against\ntrue\n--manifold\nG1,pg\n--family\nuniform,thin-band\n--points\n1..9\n--cases\n7\n--seed\n2",
    "flatdt-campaign\n--against\nt\n--persistent\n--capabilities\ni\n--claims\nedges\n--shard\n1..2\n--jobs\n0",
    "flatdt-campaign\n--against\nt\n--time\n1.5h\n--only\n7\n--time-limit\n0.5\n--wall-limit\n9\n--memory-limit\n99",
    "flatdt-campaign\n--against\nt\n--output-limit\n0\n--address-limit\n0\n--minimise-each\n1\n--minimise-runs\n9",
]
CAPABILITIES = """{"schema": "flatdt-capabilities 1", "comment": "", "manifolds": ["torus", "G1"], "metrics": "canonical",
"coordinates": "doubles", "generators": "names", "distinct": true, "min_points": 2, "max_points": {"2": 9, "3": 7},
"claims": "edges", "facet_resolution_bits": 16, "unsupported_exit": 4}
"""
SERVED = "check a 3 4\nabc\nabc\ncheck b 0 0\n\nnothing\ncheck c 1"

SMALL_CIF = """data_a
_cell_length_a 5.0
_cell_length_b 6.0
_cell_length_c 7.0
_cell_angle_alpha 90
_cell_angle_beta {beta}
_cell_angle_gamma 90
_symmetry_space_group_name_H-M '{symbol}'
{operations}loop_
_atom_site_label
_atom_site_fract_x
_atom_site_fract_y
_atom_site_fract_z
C1 0.1 0.2 0.3
C2 0.45(2) 0.05 0.61
"""

MMCIF = """data_b
_cell.length_a 10
_cell.length_b 11
_cell.length_c 12
_cell.angle_alpha 90
_cell.angle_beta 90
_cell.angle_gamma 90
_symmetry.space_group_name_H-M 'P 21 21 21'
loop_
_atom_site.id
_atom_site.label_atom_id
_atom_site.label_alt_id
_atom_site.label_asym_id
_atom_site.label_seq_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
_atom_site.pdbx_PDB_model_num
1 CA A A 1 1.0 2.0 3.0 1
2 CA B A 1 1.1 2.0 3.0 1
3 CA . A 2 4.0 5.0 6.0 2
"""

PDB = """CRYST1   10.000   11.000   12.000  90.00 100.00  90.00 P 1 21 1
ATOM      1  CA AALA A   1       1.000   2.000   3.000  1.00 10.00           C
ATOM      2  CA BALA A   1       1.100   2.000   3.000  1.00 10.00           C
HETATM    3  O   HOH A   2       4.000   5.000   6.000  1.00 10.00           O
END
"""


def crystals():
    for beta, symbol, operations in [
            ("90", "P 1", ""), ("100.5(3)", "P21", ""), ("90", "P 21 21 21", ""), ("100", "P 1 c 1", ""),
            ("100", "C 1 c 1", ""), ("90", "P c a 21", ""), ("90", "P n a 21", ""), ("90", "P 2", ""),
            ("90", "P 1 21 1", "loop_\n_symmetry_equiv_pos_as_xyz\n'x,y,z'\n'-x,y+1/2,-z'\n")]:
        yield SMALL_CIF.format(beta=beta, symbol=symbol, operations=operations)
    yield MMCIF
    yield PDB


def cgal_grid(dimension, n, sheets):
    """A stream of CGAL: the places (1/n)Z^d of the unit torus, every cube cut along the same diagonal."""
    side = n * sheets  # of the torus of all sheets, in cubes
    places = list(itertools.product(range(side), repeat=dimension))
    number = {place: k for k, place in enumerate(places)}

    def vertex(place):
        coordinates = " ".join(str(fractions.Fraction(p % n, n)) for p in place)
        return coordinates + ("" if sheets == 1 else " " + " ".join(str(p // n) for p in place))

    cells, offsets = [], []
    for cube in places:
        for axes in itertools.permutations(range(dimension)):
            corner, corners = list(cube), [cube]
            for axis in axes:
                corner[axis] += 1
                corners.append(tuple(corner))
            cells.append(" ".join(str(number[tuple(p % side for p in c)]) for c in corners))
            offsets.append(" ".join(str(sum((p // side) << (dimension - 1 - k) for k, p in enumerate(c))) for c in corners))
    neighbours = [" ".join("0" for _ in range(dimension + 1)) for _ in cells]  # they are not judged
    lines = [" ".join(["0"] * dimension + ["1"] * dimension), " ".join([str(sheets)] * dimension), str(len(places)),
             *map(vertex, places), str(len(cells)), *cells, *neighbours, *offsets]
    return "\n".join(lines) + "\n"


def cgal_streams():
    yield from (cgal_grid(*shape) for shape in [(2, 1, 1), (2, 1, 3), (2, 4, 1), (3, 1, 1), (3, 1, 3), (3, 2, 1)])
    yield cgal_grid(2, 1, 3).replace("0 0 1 1\n", "-1/2 0.25 1.5 7/4\n", 1)  # an oblong domain
    yield cgal_grid(2, 4, 1).replace("\n0 1/4\n", "\n1/8 1/4\n")  # refuted
    yield cgal_grid(2, 1, 3).replace("3 3", "3 1")  # malformed
    yield cgal_grid(2, 1, 3)[:-3]


class Seeds:
    def __init__(self, build, output):
        self.build, self.output = build, output
        self.folder = tempfile.TemporaryDirectory()
        self.scratch = pathlib.Path(self.folder.name)

    def put(self, target, data, origin):
        folder = self.output / target
        folder.mkdir(parents=True, exist_ok=True)
        name = hashlib.sha1(data).hexdigest()
        (folder / name).write_bytes(data)
        with open(self.output / "origins.tsv", "a", encoding="ascii") as origins:
            origins.write(f"{target}\t{name}\t{origin}\n")

    @staticmethod
    def origin(path):
        if path.is_relative_to(ROOT):
            return path.relative_to(ROOT).as_posix()
        return "flatdt generate: " + path.stem

    def encode(self, target, *files, origin=None):
        made = self.scratch / "made"
        runner = self.build / "fuzz" / f"fuzz_{target}"
        done = subprocess.run([runner, "--encode", made, *files], stderr=subprocess.DEVNULL, check=False)
        if done.returncode == 0:
            self.put(target, made.read_bytes(), origin or self.origin(files[0]))
        elif done.returncode not in (2, 3):  # 3: beyond the decoder's limits
            raise SystemExit(f"{runner} --encode {files}: exit code {done.returncode}")

    def encode_texts(self, target, *texts):
        files = []
        for k, text in enumerate(texts):
            files.append(self.scratch / f"text{k}")
            files[-1].write_text(text)
        self.encode(target, *files, origin="written by hand")

    def instances(self):
        yield from sorted(CORPORA.glob("*/*.instance"))
        yield from sorted(CORPORA.glob("invalid/*/*.instance"))

    def generated(self, dimension, points):
        for name in MANIFOLDS[dimension]:
            for family in FAMILIES:
                path = self.scratch / f"{name}-{family}-{points}.instance"
                subprocess.run([self.build / "ref/flatdt", "generate", "--manifold", name, "--points", str(points),
                                "--family", family, "--seed", "1", "-o", path], check=True)
                yield path

    def make(self):
        for instance in self.instances():
            text = instance.read_bytes()
            if len(text) <= LARGEST:
                self.put("parse_instance", text, self.origin(instance))
            for target in ["group", "triangulate", "predicates"]:
                self.encode(target, instance)
            triangulation = instance.with_suffix(".triangulation")
            if triangulation.exists():
                self.encode("check", instance, triangulation)
                if triangulation.stat().st_size <= LARGEST:
                    self.encode("parse_triangulation", instance, triangulation)
        for dimension, counts in [(2, [1, 2, 5, 8]), (3, [1, 2, 6])]:
            for points in counts:
                for instance in self.generated(dimension, points):
                    for target in ["triangulate", "predicates"]:
                        self.encode(target, instance)
                    if dimension == 3 and points > 1:
                        continue
                    triangulation = instance.with_suffix(".triangulation")
                    subprocess.run([self.build / "ref/flatdt", "triangulate", "-q", instance, "-o", triangulation],
                                   check=True)
                    self.encode("check", instance, triangulation)
        for command in COMMANDS:
            self.encode_texts("command_line", command)
        self.encode_texts("command_line", "flatdt-check\n--serve", "", SERVED)
        self.encode_texts("command_line", "flatdt-check\n--from\ncgal-p2t2\n-", "", cgal_grid(2, 1, 3))
        self.encode_texts("command_line", "flatdt-campaign\n--against\nt\n--capabilities\ni", CAPABILITIES)
        for crystal in crystals():
            self.encode_texts("import_crystal", crystal)
        for stream in cgal_streams():
            self.encode_texts("import_cgal", stream)
        for path in sorted(CORPORA.glob("imports/*.p?t?")):
            if path.stat().st_size <= LARGEST_STREAM:
                self.encode("import_cgal", path)


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    Seeds(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])).make()


if __name__ == "__main__":
    main()
