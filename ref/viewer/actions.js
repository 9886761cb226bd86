// What keys, buttons, the pointer and the address do.
let paint = () => {};
let pending = false;
const redraw = () => {
  if (pending) return;
  pending = true;
  requestAnimationFrame(() => { pending = false; paint(); });
};
const say = (text) => { byId("status").textContent = text; };
const selected = (id) => { const s = byId(id); return s.options[s.selectedIndex].text; };

const toControls = () => {
  for (const id of ["copies", "others", "direction"]) byId(id).value = String(state[id]);
  for (const id of ["shrink", "offset"]) byId(id).value = String(state[id]);
  for (const id of ["slice", "numbers"]) byId(id).checked = state[id];
};
const chosen = (id, value) => {
  state[id] = value;
  if (id === "direction" && value === 3) state.facing = rotate(inverse(state.turned), [0, 0, 1]);
  toControls();
  say({ copies: `Copies: ${selected("copies")}`, others: `Cells are ${selected("others")}`,
    shrink: `Size of a cell: ${state.shrink} %`, numbers: state.numbers ? "Numbers shown" : "Numbers hidden",
    slice: state.slice ? `Cut ${selected("direction")}, at ${state.offset} %` : "Not cut",
    direction: `Plane ${selected("direction")}`, offset: `Plane at ${state.offset} %` }[id]);
  redraw();
};
const turnBy = (axis, degrees) => {
  state.turned = normalised(after(turn(axis, degrees * Math.PI / 180), state.turned));
  redraw();
};
const zoomBy = (factor) => { state.zoom = Math.min(60, Math.max(0.1, state.zoom * factor)); redraw(); };

const actions = {
  left: () => turnBy([0, 1, 0], -10), right: () => turnBy([0, 1, 0], 10),
  up: () => turnBy([1, 0, 0], -10), down: () => turnBy([1, 0, 0], 10),
  in: () => zoomBy(1.2), out: () => zoomBy(1 / 1.2),
  reset: () => { state = defaults(); toControls(); say("View reset"); redraw(); },
  witness: () => {
    if (scene.figures.length === 0) return say("There is no witness to go to");
    state.focus = state.focus === "witness" ? "all" : "witness";
    state.zoom = state.focus === "witness" ? 2 : 1;
    say(state.focus === "witness" ? "At the witness" : "The whole");
    redraw();
  },
  copies: () => chosen("copies", scene.hasCopies ? (state.copies + 1) % 4 : 0),
  others: () => chosen("others", { solid: "wires", wires: "hidden", hidden: "solid" }[state.others]),
  numbers: () => chosen("numbers", !state.numbers),
  slice: () => chosen("slice", !state.slice),
  direction: () => chosen("direction", (state.direction + 1) % 4),
  nearer: () => chosen("offset", Math.min(100, state.offset + 2.5)),
  farther: () => chosen("offset", Math.max(0, state.offset - 2.5)),
};
const kKeys = {
  ArrowLeft: "left", ArrowRight: "right", ArrowUp: "up", ArrowDown: "down", "+": "in", "=": "in", "-": "out",
  r: "reset", w: "witness", c: "copies", o: "others", n: "numbers", s: "slice", d: "direction", "]": "nearer", "[": "farther",
};

const listen = (canvas) => {
  canvas.addEventListener("keydown", (event) => {
    const action = event.ctrlKey || event.metaKey || event.altKey ? undefined : kKeys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
    if (!action) return;
    event.preventDefault();
    actions[action]();
  });
  let last = null;
  canvas.addEventListener("pointerdown", (event) => { last = [event.clientX, event.clientY]; canvas.setPointerCapture(event.pointerId); });
  canvas.addEventListener("pointermove", (event) => {
    if (!last) return;
    turnBy([0, 1, 0], (event.clientX - last[0]) * 0.45);
    turnBy([1, 0, 0], (event.clientY - last[1]) * 0.45);
    last = [event.clientX, event.clientY];
  });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, () => { last = null; });
  canvas.addEventListener("wheel", (event) => { event.preventDefault(); zoomBy(Math.exp(-event.deltaY * 0.0015)); }, { passive: false });
  for (const button of document.querySelectorAll("[data-do]")) button.addEventListener("click", () => actions[button.dataset.do]());
  for (const id of ["copies", "direction", "shrink", "offset"]) byId(id).addEventListener("input", (event) => chosen(id, Number(event.target.value)));
  byId("others").addEventListener("input", (event) => chosen("others", event.target.value));
  for (const id of ["slice", "numbers"]) byId(id).addEventListener("input", (event) => chosen(id, event.target.checked));
  byId("controls").addEventListener("submit", (event) => event.preventDefault());
  window.addEventListener("resize", redraw);
  window.addEventListener("hashchange", () => { readAddress(); redraw(); });
  window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
  canvas.addEventListener("webglcontextlost", (event) => { event.preventDefault(); fail("The graphics card was lost: reload the page."); });
};

// Values of the wrong kind or out of range are left alone.
const readAddress = () => {
  const given = new URLSearchParams(location.hash.slice(1));
  const number = (key, low, high, set) => {
    const value = Number(given.get(key));
    if (given.has(key) && value >= low && value <= high) set(value);
  };
  number("yaw", -720, 720, (x) => turnBy([0, 1, 0], x));
  number("pitch", -720, 720, (x) => turnBy([1, 0, 0], x));
  number("zoom", 0.1, 60, (x) => { state.zoom = x; });
  number("copies", 0, 3, (x) => { state.copies = scene.hasCopies ? Math.floor(x) : 0; });
  number("shrink", 30, 100, (x) => { state.shrink = x; });
  number("offset", 0, 100, (x) => { state.offset = x; state.slice = true; });
  number("direction", 0, 2, (x) => { state.direction = Math.floor(x); });
  if (["solid", "wires", "hidden"].includes(given.get("others"))) state.others = given.get("others");
  if (given.get("focus") === "witness") state.focus = "witness";
  toControls();
};

const fail = (text) => {
  document.body.dataset.state = "problem";
  byId("problem").hidden = false;
  byId("problem").textContent = text;
};

const describe = () => {
  byId("title").textContent = document.title = scene.title;
  for (const note of scene.notes) byId("notes").appendChild(document.createElement("p")).textContent = note;
  byId("description").textContent = `${ownCells} cells. Arrow keys turn, + and - zoom, [ and ] move the plane; letters in ` +
    "parentheses are keys, once the picture has been clicked or reached with the Tab key. Box: the lattice cell, " +
    (scene.fullLattice ? "dotted: that of the full group." : "its edges a, b, c.");
  if (!scene.hasCopies) byId("copies").disabled = true;
  if (!hasWitness) { byId("to-witness").disabled = true; return; }
  byId("legend").hidden = false;
  const kinds = [["cell", "striped: cell"], ["other-cell", "crossed, dashed: cell beside it"], ["face", "thick: face or edge"],
    ["other-face", "thick, dashed: the other one"], ["point", "ball: vertex"]];
  for (const [kind, text] of kinds)
    if (scene.figures.some((f) => f.kind === kind)) byId("samples").appendChild(document.createElement("div")).textContent = text;
  if (scene.sphere) byId("samples").appendChild(document.createElement("div")).textContent = "dashed circles: circumscribed sphere";
};

describe();
const canvas = byId("view");
const gl = canvas.getContext("webgl", { preserveDrawingBuffer: true, antialias: true });
if (!gl) {
  fail("This browser has no WebGL, so the triangulation cannot be shown here. Draw it as .vtu and open that in ParaView.");
} else {
  try {
    paint = start(gl, canvas);
    listen(canvas);
    readAddress();
    paint();
  } catch (error) {
    fail(`The picture could not be drawn: ${error.message}`);
  }
}
