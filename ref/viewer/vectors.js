// Vectors of three numbers, rotations as quaternions [x, y, z, w], matrices of 16 numbers by columns.
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (s, a) => [s * a[0], s * a[1], s * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const length = (a) => Math.sqrt(dot(a, a));
// A zero vector has no direction: any does for drawing.
const unit = (a) => { const l = length(a); return l > 0 ? times(1 / l, a) : [0, 0, 1]; };
const mean = (list) => times(1 / list.length, list.reduce(plus, [0, 0, 0]));

const turn = (axis, angle) => [...times(Math.sin(angle / 2), axis), Math.cos(angle / 2)];
const after = (p, q) => [
  ...plus(plus(times(p[3], q), times(q[3], p)), cross(p, q)), p[3] * q[3] - dot(p, q)];
const rotate = (q, v) => {
  const t = times(2, cross(q, v));
  return plus(plus(v, times(q[3], t)), cross(q, t));
};
const inverse = (q) => [-q[0], -q[1], -q[2], q[3]];
const normalised = (q) => { const l = Math.hypot(...q); return q.map((x) => x / l); };

// Clip coordinates of the point p: turned about the centre, seen from `distance`.
const camera = (q, centre, distance, aspect, near, far) => {
  const f = 2.6, columns = [rotate(q, [1, 0, 0]), rotate(q, [0, 1, 0]), rotate(q, [0, 0, 1])];
  const fx = f / Math.max(aspect, 1), fy = f * Math.min(aspect, 1);
  const a = (near + far) / (near - far), b = 2 * near * far / (near - far);
  const moved = times(-1, rotate(q, centre));
  moved[2] -= distance;
  const matrix = [];
  for (const c of columns) matrix.push(fx * c[0], fy * c[1], a * c[2], -c[2]);
  matrix.push(fx * moved[0], fy * moved[1], a * moved[2] + b, -moved[2]);
  return matrix;
};
const project = (m, p) => [0, 1, 2, 3].map((i) => m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i]);

