"""The pictures in a real browser: headless Chromium, screenshots whose pixels are looked at. Skipped without it (exit 77).

Usage: browser_test.py FLATDT FLATDT_CHECK SOURCE_DIR [--keep FOLDER]      --keep: leaves the screenshots there
"""
import os
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

FLATDT, CHECK, SOURCE = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
CHROMIUM = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
SOFTWARE_GL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
WIDTH, HEIGHT = 760, 520
KEYS = ["ArrowLeft", "c", "o", "s", "]", "d", "w", "n", "+"]
PRESS = """<script>
const seen = [];
for (const key of %s) {
  byCanvas.dispatchEvent(new KeyboardEvent("keydown", { key, cancelable: true }));
  seen.push(key + "=" + document.getElementById("status").textContent);
}
document.body.dataset.seen = seen.join(";");
</script>""".replace("byCanvas", 'document.getElementById("view")')


def require(condition, what):
    if not condition:
        sys.exit(f"browser_test: {what}")


def chromium(work, *arguments):
    command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars", "--no-first-run",
               "--disable-extensions", "--disable-background-networking", "--host-resolver-rules=MAP * ~NOTFOUND",
               f"--user-data-dir={work}/profile", f"--window-size={WIDTH},{HEIGHT}", "--virtual-time-budget=2000",
               *arguments]
    done = subprocess.run(command, capture_output=True, timeout=300)
    require(done.returncode == 0, f"{arguments}: {done.stderr[-2000:]!r}")
    return done.stdout.decode("utf-8", "replace")


def read_png(path):
    """Rows of (red, green, blue) of a PNG with 8 bits a channel, not interlaced."""
    data = path.read_bytes()
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            require(depth == 8 and colour in (2, 6) and interlaced == 0, f"{path}: an unknown kind of PNG")
        if kind == b"IDAT":
            packed += body
        at += size + 12
    channels = 3 if colour == 2 else 4
    raw, stride = zlib.decompress(packed), channels * width
    previous, rows = bytearray(stride), []
    for y in range(height):
        kind, line = raw[y * (stride + 1)], bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for k in range(stride):
            left = line[k - channels] if k >= channels else 0
            above, corner = previous[k], previous[k - channels] if k >= channels else 0
            if kind == 1:
                line[k] = (line[k] + left) & 255
            elif kind == 2:
                line[k] = (line[k] + above) & 255
            elif kind == 3:
                line[k] = (line[k] + (left + above) // 2) & 255
            elif kind == 4:
                guess = left + above - corner
                near = min((abs(guess - left), 0, left), (abs(guess - above), 1, above), (abs(guess - corner), 2, corner))
                line[k] = (line[k] + near[2]) & 255
        rows.append([tuple(line[k:k + 3]) for k in range(0, stride, channels)])
        previous = line
    return rows


def stage(rows):
    """The part of a page's screenshot that only the drawing covers."""
    return [row[20:470] for row in rows[90:420]]


def count_red(rows):
    """Pixels of the colour of the witness, on light and on dark paper; nothing else has so much red."""
    return sum(red - green > 80 and red - blue > 80 for row in rows for red, green, blue in row)


def changed(a, b):
    """The share of pixels that differ."""
    total = sum(len(row) for row in a)
    return sum(p != q for r, s in zip(a, b) for p, q in zip(r, s)) / total


class Screen:
    def __init__(self, work, keep):
        self.work, self.keep = work, keep

    def shot(self, name, file, fragment="", *arguments):
        path = self.work / (name + ".png")
        chromium(self.work, *SOFTWARE_GL, f"--screenshot={path}", *arguments, f"file://{file}#{fragment}")
        require(path.exists(), f"no screenshot {name}")
        if self.keep:
            shutil.copy(path, self.keep)
        return read_png(path)

    def page(self, file, *arguments):
        return chromium(self.work, *arguments, "--dump-dom", f"file://{file}")


def make_pages(work):
    pair = SOURCE / "corpora/invalid/delaunay.empty/3d-flip-2-3.instance"
    triangulation = pair.with_suffix(".triangulation")
    with open(work / "v.json", "wb") as file:
        subprocess.run([CHECK, "--json", pair, triangulation], stdout=file, timeout=300, check=False)
    for name, more in (("refuted", ["--verdict", work / "v.json"]), ("plain", [])):
        subprocess.run([FLATDT, "draw", pair, triangulation, *more, "-o", work / (name + ".html")], check=True,
                       capture_output=True, timeout=300)
    return work / "refuted.html", work / "plain.html"


def look_at_pages(screen, work):
    refuted, plain = make_pages(work)
    first = stage(screen.shot("refuted", refuted))
    colours = {pixel for row in first for pixel in row}
    require(len(colours) > 50, f"the page is blank: {len(colours)} colours")
    marked = count_red(first)
    require(marked > 300, f"the witness is not highlighted: {marked} pixels of its colour")
    turned = stage(screen.shot("turned", refuted, "yaw=40&pitch=15"))
    require(changed(first, turned) > 0.02, f"turning changes {changed(first, turned):.4f} of the pixels only")
    solid = stage(screen.shot("plain", plain))
    require(count_red(solid) == 0, "something is highlighted without a verdict")
    cut = stage(screen.shot("cut", plain, "offset=40&direction=1"))
    require(changed(solid, cut) > 0.05, f"the plane changes {changed(solid, cut):.4f} of the pixels only")
    dark = stage(screen.shot("dark", refuted, "focus=witness&zoom=2", "--blink-settings=preferredColorScheme=0"))
    require(dark[0][0] != first[0][0] and max(dark[0][0]) < 64, f"not dark: {dark[0][0]}")
    require(count_red(dark) > 300, "the witness is not highlighted on a dark screen")
    copies = stage(screen.shot("copies", plain, "copies=2"))
    require(changed(solid, copies) > 0.05, "copies change nothing")


def press_keys(screen, work):
    text = (work / "refuted.html").read_text(encoding="ascii")
    pressed = work / "pressed.html"
    pressed.write_text(text.replace("</body>", PRESS % KEYS + "</body>"), encoding="ascii")
    page = screen.page(pressed, *SOFTWARE_GL)
    require('data-state="drawn"' in page, "the page is not drawn")
    seen = re.search(r'data-seen="([^"]*)"', page).group(1).split(";")
    expected = ["ArrowLeft=", "c=Copies: one lattice cell", "o=Cells are hidden", "s=Cut along b and c, at 50 %",
                "]=Plane at 52.5 %", "d=Plane along a and c", "w=At the witness", "n=Numbers shown", "+=Numbers shown"]
    require(seen == expected, f"keys do {seen}")
    without = screen.page(work / "refuted.html", "--disable-gpu", "--disable-3d-apis")
    require('data-state="problem"' in without and "has no WebGL" in without, "no message where WebGL is missing")
    require('id="problem" role="alert" hidden' not in without, "the message is hidden")


def look_at_svg(screen):
    file = SOURCE / "docs/pictures/refuted.svg"
    light = screen.shot("svg", file)
    dark = screen.shot("svg-dark", file, "", "--blink-settings=preferredColorScheme=0")
    require(min(light[20][20]) > 200 and max(dark[20][20]) < 64, f"paper: {light[20][20]}, {dark[20][20]}")
    require(count_red(light) > 1000 and count_red(dark) > 1000, "the witness is not highlighted in SVG")


def main():
    if CHROMIUM is None:
        print("browser_test: no Chromium is installed (scripts/install-packages browser): skipped")
        sys.exit(77)
    keep = None
    if "--keep" in sys.argv:
        keep = pathlib.Path(sys.argv[sys.argv.index("--keep") + 1])
        keep.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        os.environ["HOME"] = name
        work = pathlib.Path(name)
        screen = Screen(work, keep)
        look_at_pages(screen, work)
        press_keys(screen, work)
        look_at_svg(screen)
    print("pages and SVG in Chromium: drawn, highlighted, turned, cut, copied, dark, by keys, and without WebGL")


main()
