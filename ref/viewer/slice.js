// The section of the cells by the plane dot(normal, x) = offset: triangles and outlines.
// A cell meets a plane in a triangle or a quadrilateral; corners on the plane count as below it.
const sectionOf = (corners, normal, offset) => {
  const height = corners.map((p) => dot(normal, p) - offset);
  const above = [0, 1, 2, 3].filter((k) => height[k] > 0), below = [0, 1, 2, 3].filter((k) => !(height[k] > 0));
  const at = (i, j) => {
    const t = height[i] / (height[i] - height[j]);
    return plus(times(1 - t, corners[i]), times(t, corners[j]));
  };
  if (above.length === 1) return below.map((k) => at(above[0], k));
  if (below.length === 1) return above.map((k) => at(k, below[0]));
  if (above.length !== 2) return [];
  const [a, b] = above, [c, d] = below;
  return [at(a, c), at(a, d), at(b, d), at(b, c)];
};

const section = (state, normal, offset) => {
  const faces = [], lines = [];
  const count = state.copies > 0 ? scene.cells.length : ownCells, shrink = state.shrink / 100;
  for (const shift of translations(state.copies))
    for (let n = 0; n < count; ++n) {
      const cell = scene.cells[n], whole = cornersOf(cell).map((p) => plus(p, shift)), middle = mean(whole);
      const corners = whole.map((p) => plus(middle, times(shrink, minus(p, middle))));
      const polygon = sectionOf(corners, normal, offset);
      const shade = (cell[4] * 0.61803398875) % 1, flag = isViolated.has(cell[4]) ? 1 : 0;
      for (let k = 2; k < polygon.length; ++k)
        for (const p of [polygon[0], polygon[k - 1], polygon[k]]) faces.push(...p, ...p, ...normal, shade, flag);
      polygon.forEach((p, k) => lines.push(...p, ...polygon[(k + 1) % polygon.length]));
    }
  return { faces: new Float32Array(faces), lines: new Float32Array(lines) };
};

