// What is drawn, as arrays of vertices.
const scene = JSON.parse(document.getElementById("scene").textContent);
const isViolated = new Set(scene.violated);
const ownCells = scene.cells.filter((c) => c[5] === 0).length;  // they come first

// Translations by which N x N x N lattice cells are filled.
const translations = (copies) => {
  const list = [], side = scene.hasCopies ? Math.max(copies, 1) : 1;
  for (let k = 0; k < side; ++k)
    for (let j = 0; j < side; ++j)
      for (let i = 0; i < side; ++i)
        list.push(plus(plus(times(i, scene.lattice[0]), times(j, scene.lattice[1])), times(k, scene.lattice[2])));
  return list;
};

const kFacets = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];
const kEdges = [[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]];
const cornersOf = (cell) => cell.slice(0, 4).map((k) => scene.places[k]);

// Corner, middle of its cell, normal, shade in [0, 1), 1 if the witness names the cell.
const kCellFloats = 11;
const cellVertices = () => {
  const out = new Float32Array(scene.cells.length * 12 * kCellFloats);
  let at = 0;
  for (const cell of scene.cells) {
    const corners = cornersOf(cell), middle = mean(corners);
    const shade = (cell[4] * 0.61803398875) % 1;  // neighbours in the list get different shades
    for (const facet of kFacets) {
      const [a, b, c] = facet.map((k) => corners[k]);
      const normal = unit(cross(minus(b, a), minus(c, a)));
      for (const corner of [a, b, c]) {
        out.set([...corner, ...middle, ...normal, shade, isViolated.has(cell[4]) ? 1 : 0], at);
        at += kCellFloats;
      }
    }
  }
  return out;
};
const edgeVertices = () => {
  const out = new Float32Array(scene.cells.length * 12 * kCellFloats);
  let at = 0;
  for (const cell of scene.cells) {
    const corners = cornersOf(cell), middle = mean(corners);
    for (const edge of kEdges)
      for (const k of edge) {
        out.set([...corners[k], ...middle, 0, 0, 1, 0, isViolated.has(cell[4]) ? 1 : 0], at);
        at += kCellFloats;
      }
  }
  return out;
};

// Solid shapes: position, normal, hatching (0 none, 1 stripes, 2 crossed stripes).
class Solid {
  constructor() { this.values = []; }
  triangle(corners, normals, hatching) {
    corners.forEach((p, k) => this.values.push(...p, ...normals[k], hatching));
  }
  flat(a, b, c, hatching) {
    const n = unit(cross(minus(b, a), minus(c, a)));
    this.triangle([a, b, c], [n, n, n], hatching);
  }
  tube(a, b, radius) {
    const sides = 10, along = unit(minus(b, a));
    const u = unit(cross(along, Math.abs(along[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0])), v = cross(along, u);
    const spoke = (k) => {
      const t = 2 * Math.PI * k / sides;
      return plus(times(Math.cos(t), u), times(Math.sin(t), v));
    };
    for (let k = 0; k < sides; ++k) {
      const m = spoke(k), n = spoke(k + 1), [p, q] = [times(radius, m), times(radius, n)];
      this.triangle([plus(a, p), plus(a, q), plus(b, p)], [m, n, m], 0);
      this.triangle([plus(b, p), plus(a, q), plus(b, q)], [m, n, n], 0);
      this.triangle([a, plus(a, p), plus(a, q)].reverse(), [along, along, along], 0);
      this.triangle([b, plus(b, p), plus(b, q)], [along, along, along], 0);
    }
  }
  dashes(a, b, radius) {
    const steps = Math.min(200, Math.max(3, Math.round(length(minus(b, a)) / (radius * 5)))) * 2 + 1;
    const at = (k) => plus(a, times(k / steps, minus(b, a)));
    for (let k = 0; k < steps; k += 2) this.tube(at(k), at(k + 1), radius);
  }
  ball(p, radius) {
    const rows = 8, columns = 14;
    const point = (i, j) => {
      const s = Math.PI * i / rows, t = 2 * Math.PI * j / columns;
      return [Math.sin(s) * Math.cos(t), Math.sin(s) * Math.sin(t), Math.cos(s)];
    };
    for (let i = 0; i < rows; ++i)
      for (let j = 0; j < columns; ++j) {
        const [a, b, c, d] = [point(i, j), point(i + 1, j), point(i + 1, j + 1), point(i, j + 1)];
        const place = (n) => plus(p, times(radius, n));
        this.triangle([place(a), place(b), place(c)], [a, b, c], 0);
        this.triangle([place(a), place(c), place(d)], [a, c, d], 0);
      }
  }
}

// The witness: a cell is striped with whole edges, the cell beside it crossed with dashed ones; edges are thick,
// the other one of two dashed.
const witnessVertices = (unitLength) => {
  const solid = new Solid(), thin = 0.006 * unitLength, thick = 2.2 * thin;
  for (const figure of scene.figures) {
    const c = figure.corners, dashed = figure.kind.startsWith("other");
    const line = (a, b, radius) => dashed ? solid.dashes(a, b, radius) : solid.tube(a, b, radius);
    if (c.length === 1) solid.ball(c[0], 3.2 * thin);
    if (c.length === 2) line(c[0], c[1], thick);
    if (c.length === 3) solid.flat(c[0], c[1], c[2], dashed ? 2 : 1);
    if (c.length === 4) for (const f of kFacets) solid.flat(...f.map((k) => c[k]), dashed ? 2 : 1);
    if (c.length > 2)
      for (let i = 0; i < c.length; ++i)
        for (let j = i + 1; j < c.length; ++j) line(c[i], c[j], c.length === 3 ? thick : thin);
    if (c.length > 1) for (const p of c) solid.ball(p, 1.8 * thin);
  }
  return new Float32Array(solid.values);
};

// Lines: pairs of positions. The lattice cell; that of the full group where it is smaller, dotted.
const boxLines = (v, dots) => {
  const out = [], corner = (k) => [0, 1, 2].reduce((p, i) => k >> i & 1 ? plus(p, v[i]) : p, [0, 0, 0]);
  for (let k = 0; k < 8; ++k)
    for (let i = 0; i < 3; ++i) {
      if (k >> i & 1) continue;
      const a = corner(k), step = times(1 / (2 * dots), v[i]);
      for (let s = 0; s < dots; ++s) out.push(...plus(a, times(2 * s, step)), ...plus(a, times(2 * s + 1, step)));
      if (dots === 1) out.push(...plus(a, step), ...plus(a, v[i]));
    }
  return new Float32Array(out);
};
const sphereLines = () => {
  if (!scene.sphere) return new Float32Array(0);
  const out = [], { centre, radius } = scene.sphere, steps = 96;
  const arc = (at) => {
    for (let k = 0; k < steps; ++k)
      if (k % 4 !== 3) for (const t of [k, k + 1]) out.push(...plus(centre, times(radius, at(2 * Math.PI * t / steps))));
  };
  for (let m = 0; m < 6; ++m) {
    const s = Math.PI * m / 6;
    arc((t) => [Math.cos(t) * Math.cos(s), Math.cos(t) * Math.sin(s), Math.sin(t)]);
  }
  for (const h of [-0.75, -0.4, 0, 0.4, 0.75])
    arc((t) => [Math.sqrt(1 - h * h) * Math.cos(t), Math.sqrt(1 - h * h) * Math.sin(t), h]);
  return new Float32Array(out);
};

