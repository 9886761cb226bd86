// State, keys and controls. The part of the address after # sets the view: #yaw=30&pitch=20&zoom=1.5&copies=1...
const byId = (id) => document.getElementById(id);
const hasWitness = scene.figures.length > 0 || scene.violated.length > 0;
const all = scene.places.concat(...scene.figures.map((f) => f.corners));
const isFaded = hasWitness && scene.figures.length > 0;
const defaults = () => ({
  turned: normalised(after(turn([1, 0, 0], -1.15), turn([0, 0, 1], -0.45))), zoom: 1, focus: "all",
  copies: scene.hasCopies ? Math.min(scene.copies, 3) : 0, others: isFaded ? "wires" : "solid", shrink: 88,
  numbers: scene.places.length <= 80, slice: false, direction: 0, offset: 50, facing: [0, 0, 1],
});
let state = defaults();

// The centre, radius and extreme places of what is shown; the same until other copies are.
let reached = null;
const reach = () => {
  if (reached && reached.copies === state.copies) return reached;
  const shifts = translations(state.copies), list = [];
  for (const p of all.length > 0 ? all : [[0, 0, 0]])
    for (const s of [shifts[0], shifts[shifts.length - 1]]) list.push(plus(p, s));
  const low = [0, 1, 2].map((i) => list.reduce((m, p) => Math.min(m, p[i]), Infinity));
  const high = [0, 1, 2].map((i) => list.reduce((m, p) => Math.max(m, p[i]), -Infinity));
  const radius = Math.max(length(minus(high, low)) / 2, 1e-9);
  reached = { copies: state.copies, centre: times(0.5, plus(low, high)), radius, list };
  return reached;
};
const normalOf = () => state.direction < 3
  ? unit(cross(scene.lattice[(state.direction + 1) % 3], scene.lattice[(state.direction + 2) % 3])) : state.facing;

const rgb = (text) => [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16) / 255);
const palette = () => {
  const dark = window.matchMedia("(prefers-color-scheme: dark)").matches;
  const [paper, ink, frame, accent, low, high] = dark
    ? ["#12171d", "#cfe3f7", "#f2b36b", "#ff8a80", "#1f3a54", "#4a7ba8"]
    : ["#fdfdfb", "#1d3f60", "#8a4b08", "#b3261e", "#aecbe6", "#e9f1f9"];
  return { paper: rgb(paper), ink: rgb(ink), frame: rgb(frame), accent: rgb(accent), low: rgb(low), high: rgb(high),
    paperText: paper, inkText: dark ? "#eef3f8" : "#16202b", frameText: frame };
};

const start = (gl, canvas) => {
  const painter = new Painter(gl), size = reach().radius;
  const cells = painter.buffer(cellVertices(), "cells"), edges = painter.buffer(edgeVertices(), "cells");
  const witness = painter.buffer(witnessVertices(size), "solid"), sphere = painter.buffer(sphereLines(), "lines");
  const box = painter.buffer(boxLines(scene.lattice, 1), "lines");
  const full = painter.buffer(scene.fullLattice ? boxLines(scene.fullLattice, 8) : new Float32Array(0), "lines");
  const points = painter.buffer(new Float32Array(scene.places.flat()), "lines");
  const ownPlaces = new Set(scene.cells.slice(0, ownCells).flatMap((c) => c.slice(0, 4))).size;  // they come first
  let cut = null;

  const paint = () => {
    const ratio = window.devicePixelRatio || 1, labels = byId("labels");
    for (const c of [canvas, labels]) {
      c.width = Math.max(1, Math.round(canvas.clientWidth * ratio));
      c.height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    }
    const { centre, radius, list } = reach(), colours = palette(), normal = normalOf();
    const focus = state.focus === "witness" && scene.figures.length > 0 ? mean(scene.figures[0].corners) : centre;
    const distance = 3.4 * radius / state.zoom, aspect = canvas.width / canvas.height;
    const near = Math.max(distance - 2.2 * radius - length(minus(focus, centre)), 0.01 * distance);
    const matrix = camera(state.turned, focus, distance, aspect, near, distance + 2.2 * radius + length(minus(focus, centre)));
    const heights = list.map((p) => dot(normal, p)), low = heights.reduce((m, h) => Math.min(m, h)), high = heights.reduce((m, h) => Math.max(m, h));
    const offset = low + (high - low) * state.offset / 100;
    const light = rotate(inverse(state.turned), unit([0.35, 0.5, 0.8]));
    const common = { view: matrix, shift: [0, 0, 0], shrink: state.shrink / 100, plane: [...normal, offset], sliced: state.slice ? 1 : 0,
      light, low: colours.low, high: colours.high, accent: colours.accent, paper: colours.paper, flat_: 0 };
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(...colours.paper, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    painter.draw("solid", gl.TRIANGLES, witness, common);
    const used = state.copies > 0 ? scene.cells.length : ownCells;
    const ink = [...colours.ink, state.others === "solid" ? 0.9 : 0.4], marked = { ...common, ink: [...colours.accent, 1] };
    for (const shift of translations(state.copies)) {
      const here = { ...common, shift, ink };
      if (state.others === "solid") painter.draw("cells", gl.TRIANGLES, cells, here, used * 12);
      if (state.others !== "hidden")
        painter.draw("lines", gl.LINES, edges, state.others === "wires" ? { ...here, shrink: 1 } : here, used * 12);
      painter.draw("points", gl.POINTS, points, { ...here, size: 6 * ratio, ink: [...colours.ink, 1] },
        state.copies > 0 ? points.count : ownPlaces);
    }
    if (state.slice && state.others === "solid") {
      const key = [state.copies, state.shrink, ...normal, offset].join();
      if (!cut || cut.key !== key) {
        if (cut) [cut.faces, cut.lines].forEach((buffer) => painter.release(buffer));
        const { faces, lines } = section(state, normal, offset);
        cut = { key, faces: painter.buffer(faces, "cells"), lines: painter.buffer(lines, "lines") };
      }
      const whole = { ...common, sliced: 0, flat_: 1, shrink: 1 };
      painter.draw("cells", gl.TRIANGLES, cut.faces, whole);
      painter.draw("lines", gl.LINES, cut.lines, { ...whole, ink: [...colours.ink, 1] });
    }
    const frame = { ...common, sliced: 0, shrink: 1, ink: [...colours.frame, 1] };
    painter.draw("lines", gl.LINES, box, frame);
    painter.draw("lines", gl.LINES, full, frame);
    painter.draw("lines", gl.LINES, sphere, { ...marked, sliced: 0, shrink: 1 });
    drawLabels(labels, matrix, state, colours, (p) => state.slice && dot(normal, p) > offset);
    document.body.dataset.state = gl.getError() === gl.NO_ERROR ? "drawn" : "error";
  };
  return paint;
};

