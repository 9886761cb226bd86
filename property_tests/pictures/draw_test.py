"""flatdt draw on right, wrong and hostile files: what the pictures hold, and that nothing crashes it.

Usage: draw_test.py FLATDT FLATDT_CHECK CORPORA [--all]      --all: every pair of corpora/invalid, not two a folder
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

FLATDT, CHECK, CORPORA = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
ALL = "--all" in sys.argv[4:]
SVG = "{http://www.w3.org/2000/svg}"
FIGURES = {"cell-points", "facet-vertices", "edge", "other-edge", "face", "other-face", "vertex"}
checks = 0


def require(condition, what):
    global checks
    checks += 1
    if not condition:
        sys.exit(f"draw_test: {what}")


def draw(codes, *arguments):
    done = subprocess.run([FLATDT, "draw", *map(str, arguments)], capture_output=True, timeout=300)
    require(done.returncode in codes, f"{arguments}: exit {done.returncode}: {done.stderr[-2000:]!r}")
    return done


def judged(pair, folder):
    """The verdict object of a pair of files, and the file that holds it."""
    done = subprocess.run([CHECK, "--json", str(pair), str(pair.with_suffix(".triangulation"))], capture_output=True,
                          timeout=300)
    path = folder / "verdict.json"
    path.write_bytes(done.stdout)
    return json.loads(done.stdout), path


def has_number_problem(text):
    return any(word in text.lower() for word in (" nan", " inf", ">nan", "\"nan", "-nan", "(nan", "-inf", ">inf"))


def check_svg(path, failed, name):
    text = path.read_text(encoding="utf-8")
    root = ElementTree.fromstring(text)
    require(root.tag == SVG + "svg", f"{name}: not an SVG")
    require("prefers-color-scheme" in text, f"{name}: follows no colour scheme")
    groups = {g.get("class"): g for g in root.iter(SVG + "g")}
    require({"copies", "cells", "witness", "points"} <= set(groups), f"{name}: groups {list(groups)}")
    require(any(p.get("class") == "domain" for p in root.iter(SVG + "path")), f"{name}: no fundamental domain")
    if any(FIGURES & set(c["witness"]) for c in failed):
        require(len(groups["witness"]) > 0, f"{name}: the witness is not drawn")
    captions = " ".join(t.text or "" for t in root.iter(SVG + "text") if t.get("class") == "caption")
    require("REFUTED" in captions and any(c["name"] in captions for c in failed), f"{name}: caption {captions!r}")
    for element in root.iter():
        for key in ("d", "cx", "cy", "r", "x", "y"):
            require(not has_number_problem(" " + (element.get(key) or "")), f"{name}: {key} is no number")


class Grid:
    """A VTU file: every array as a list of numbers, checked for consistency."""

    def __init__(self, path, name):
        root = ElementTree.parse(path).getroot()
        require(root.tag == "VTKFile" and root.get("type") == "UnstructuredGrid", f"{name}: not an unstructured grid")
        piece = root.find("UnstructuredGrid/Piece")
        self.points_count, self.cells_count = int(piece.get("NumberOfPoints")), int(piece.get("NumberOfCells"))
        self.data = {}
        for array in root.iter("DataArray"):
            convert = float if array.get("type") == "Float64" else int
            self.data[array.get("Name")] = [convert(word) for word in (array.text or "").split()]
        flat = self.data["Points"]
        require(len(flat) == 3 * self.points_count and len(self.data["point"]) == self.points_count, f"{name}: points")
        for key in ("offsets", "types", "cell", "copy", "violated", "figure"):
            require(len(self.data[key]) == self.cells_count, f"{name}: {key}")
        self.points = [flat[3 * k:3 * k + 3] for k in range(self.points_count)]
        corners, begin = {1: 1, 3: 2, 5: 3, 10: 4}, 0
        self.cells = []
        for kind, end in zip(self.data["types"], self.data["offsets"]):
            require(end - begin == corners[kind], f"{name}: a cell of type {kind} with {end - begin} corners")
            self.cells.append(self.data["connectivity"][begin:end])
            begin = end
        require(begin == len(self.data["connectivity"]), f"{name}: connectivity")
        require(all(0 <= k < self.points_count for cell in self.cells for k in cell), f"{name}: an index")

    def volume(self, cell):
        a, b, c = ([self.points[k][x] - self.points[cell[0]][x] for x in range(3)] for k in cell[1:])
        return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6


def read_by_vtk(path, grid):
    """Where VTK is installed for this Python, it must read the same."""
    try:
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError:
        return False
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    output = reader.GetOutput()
    require(output.GetNumberOfCells() == grid.cells_count and output.GetNumberOfPoints() == grid.points_count, "vtk")
    return True


def check_vtu(path, failed, name):
    grid = Grid(path, name)
    named = {grid.data["cell"][k] for k in range(grid.cells_count)
             if grid.data["violated"][k] and grid.data["figure"][k] == 0}
    texts = [c["witness"].get(key, "") for c in failed for key in ("cell", "other-cell", "cells")]
    told = {int(word) for text in texts for word in text.split(",") if word}
    extra = any(c["name"] in ("facets.paired", "subgroup.member") for c in failed)  # these name further cells
    require(extra or named <= told, f"{name}: marks {named}, the witness names {told}")
    if any(FIGURES & set(c["witness"]) for c in failed):
        require(any(grid.data["figure"]), f"{name}: the witness is not drawn")
    return grid


def refuted_pairs():
    for folder in sorted((CORPORA / "invalid").iterdir()):
        for dimension in ("2d", "3d"):
            pairs = sorted(p for p in folder.glob(dimension + "*.instance") if p.with_suffix(".triangulation").exists())
            yield from pairs if ALL else pairs[:1]


def draw_refuted(folder):
    count = 0
    for pair in refuted_pairs():
        verdict, file = judged(pair, folder)
        name = f"{pair.parent.name}/{pair.stem}"
        failed = [c for c in verdict["conditions"] if c["status"] == "fails"]
        flat = pair.name.startswith("2d")
        output = folder / ("p.svg" if flat else "p.vtu")
        triangulation = pair.with_suffix(".triangulation")
        if verdict["verdict"] != "REFUTED":  # inadmissible or malformed: nothing to draw, but no crash
            draw((0, 2, 3), pair, triangulation, "--verdict", file, "-o", output)
            continue
        draw((0,), pair, triangulation, "--verdict", file, "-o", output)
        (check_svg if flat else check_vtu)(output, failed, name)
        count += 1
        if ALL:
            for condition in failed:
                draw((0,), pair, triangulation, "--verdict", file, "--condition", condition["name"], "-o", output)
                (check_svg if flat else check_vtu)(output, [condition], name)
    require(count >= 20, f"only {count} refuted pairs")
    return count


def draw_copies(folder):
    """Copies fill the lattice cells exactly once, positively oriented; without copies each cell is there once."""
    vtk = False
    for name, images in (("dicosm-50", 2), ("dicosm-covers-didicosm", 2)):
        pair = CORPORA / "valid" / (name + ".instance")
        output, triangulation = folder / "p.vtu", pair.with_suffix(".triangulation")
        sizes = []
        for copies in (0, 1, 2):
            draw((0,), pair, triangulation, "--copies", copies, "-o", output)
            grid = Grid(output, name)
            volumes = [grid.volume(cell) for cell in grid.cells]
            require(min(volumes) > 0, f"{name}: a cell is turned inside out")
            sizes.append((grid.cells_count, sum(volumes)))
        vtk = read_by_vtk(output, grid)
        require(sizes[1][0] == images * sizes[0][0] and sizes[2][0] == 8 * sizes[1][0], f"{name}: copies {sizes}")
        for k, factor in ((1, images), (2, 8 * images)):
            require(abs(sizes[k][1] - factor * sizes[0][1]) < 1e-6 * sizes[k][1], f"{name}: volumes {sizes}")
        require(abs(sizes[1][1] - round(sizes[1][1])) < 1e-6, f"{name}: the lattice has an integral volume: {sizes}")
    return vtk


def draw_page(folder):
    pair = CORPORA / "invalid" / "delaunay.empty" / "3d-flip-2-3.instance"
    _, file = judged(pair, folder)
    output = folder / "p.html"
    draw((0,), pair, pair.with_suffix(".triangulation"), "--verdict", file, "-o", output)
    page = output.read_text(encoding="ascii")
    require("://" not in page and "src=" not in page and "import" not in page, "the page wants something of elsewhere")
    data = json.loads(page.split('id="scene">')[1].split("</script>")[0])
    require({f["kind"] for f in data["figures"]} == {"cell", "other-cell", "point"} and data["sphere"], "its witness")
    before = output.read_bytes()
    draw((0,), pair, pair.with_suffix(".triangulation"), "--verdict", file, "-o", output)
    require(output.read_bytes() == before, "the page is not the same twice")


def draw_hostile(folder):
    """Verdicts of other files or of no file; outputs of the wrong kind."""
    pair = CORPORA / "invalid" / "delaunay.empty" / "2d-flip.instance"
    triangulation, file, output = pair.with_suffix(".triangulation"), folder / "h.json", folder / "h.svg"
    head = '{"schema":"flatdt-check 1","verdict":"REFUTED","conditions":'
    condition = head + '[{"name":"delaunay.empty","status":"fails","witness":%s}]}'
    big = '"(' + "9" * 200000 + ',0);(0,0);(0,1)"'
    cases = [("", 2), ("[]", 2), ("nul", 2), ('"flatdt-check 1"', 2), ('{"schema":"flatdt-check 2"}', 2), (head + "{}}", 2),
             (head + "[1]}", 2), ('{"a":' * 20000, 2), ("[" * 100000 + "]" * 100000, 2), (head + "[]}", 0),
             (head + "[" + ",".join(['{"name":"x","status":"fails"}'] * 101) + "]}", 2), (head + "[]} x", 2),
             (head + '[{"name":"<b>","status":"fails"}]}', 2), (head + '[{"name":"x","status":"fails"}]}', 0),
             (condition % "[]", 0), (condition % '{"cell":7,"apex":null}', 0), (condition % '{"cell":"99999999999"}', 0),
             (condition % '{"cell-points":"(0,0);(1/0,0);(1,1)"}', 0), (condition % ('{"cell-points":' + big + "}"), 0),
             (condition % '{"cell-points":"(0,0);(1,0);(2,0)","facet":"0","apex":"(1e900,1)"}', 0),
             (condition % '{"cell-points":"(0,0);(1,0);(1e1000,1e-1000)","facet":"2","apex":"(5,5)"}', 0),
             (condition % ('{"cell":' + "[" * 20 + "]" * 20 + "}"), 2), (condition % '{"cell":"[[[[[[[[[[[[[[[[[[\\""}', 0),
             (condition % '{"cell":"\\u0000<&\\ud83d\\ude00"}', 0), (condition % '{"cell":"\\ud83d"}', 2)]
    for text, code in cases:
        file.write_text(text, encoding="utf-8")
        output.unlink(missing_ok=True)
        draw((code,), pair, triangulation, "--verdict", file, "-o", output)
        require(output.exists() == (code == 0), f"{text[:80]}: output")
        if code == 0:
            ElementTree.parse(output)
    file.write_bytes(b'{"schema":"flatdt-check 1\xff"}')
    draw((2,), pair, triangulation, "--verdict", file, "-o", output)
    draw((2,), pair, triangulation, "--verdict", folder / "missing.json", "-o", output)
    draw((2,), pair, "-", "--verdict", "-", "-o", output)
    draw((2,), pair, triangulation, "-o", "")
    long_name = folder / ("n" * 251 + ".svg")
    draw((0,), pair, triangulation, "-o", long_name)
    require(long_name.stat().st_size > 0, "a name of 255 bytes")
    (folder / "link.svg").symlink_to(long_name)
    long_name.write_text("")
    draw((0,), pair, triangulation, "-o", folder / "link.svg")
    require((folder / "link.svg").is_symlink() and long_name.stat().st_size > 0, "an output through a link")
    draw((2,), pair, triangulation, "-o", folder / "h.html")
    draw((2,), pair, triangulation, "--condition", "volume.exact", "-o", output)
    draw((2,), pair, triangulation, "--copies", "6", "-o", output)
    draw((0,), pair, triangulation, "-o", folder / "h.vtu")
    Grid(folder / "h.vtu", "2D")
    solid = CORPORA / "valid" / "dicosm-1.instance"
    draw((2,), solid, solid.with_suffix(".triangulation"), "-o", output)
    draw((2,), solid, solid.with_suffix(".triangulation"), "--violation", "-o", folder / "h.vtu")
    draw((0,), solid, solid.with_suffix(".triangulation"), "--two-cycle", "-o", folder / "h.vtu")
    done = draw((0,), solid, solid.with_suffix(".triangulation"), "--format", "html")
    require(done.stdout.startswith(b"<!DOCTYPE html>"), "standard output")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        count = draw_refuted(folder)
        vtk = draw_copies(folder)
        draw_page(folder)
        draw_hostile(folder)
    print(f"{count} refuted triangulations drawn; VTU read by {'VTK and ' if vtk else ''}an XML reader; {checks} checks")


main()
