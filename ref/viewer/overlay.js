// Numbers of points and names of the axes, written over the picture; not among more than 400 places.
const drawLabels = (canvas, matrix, state, colours, isCut) => {
  const context = canvas.getContext("2d"), { width, height } = canvas, ratio = window.devicePixelRatio || 1;
  context.clearRect(0, 0, width, height);
  context.lineWidth = 3 * ratio;
  context.lineJoin = "round";
  const write = (p, text, size, colour) => {
    const [x, y, , w] = project(matrix, p);
    if (!(w > 0)) return;
    context.font = `${size * ratio}px system-ui, Helvetica, Arial, sans-serif`;
    const at = [(1 + x / w) * width / 2 + 5 * ratio, (1 - y / w) * height / 2 - 5 * ratio];
    context.strokeStyle = colours.paperText;
    context.strokeText(text, ...at);
    context.fillStyle = colour;
    context.fillText(text, ...at);
  };
  ["a", "b", "c"].forEach((name, k) => write(times(0.5, scene.lattice[k]), name, 17, colours.frameText));
  if (!state.numbers || state.copies > 1 || scene.places.length > 400) return;
  const seen = new Set();
  for (const cell of scene.cells.slice(0, state.copies > 0 ? scene.cells.length : ownCells))
    for (const k of cell.slice(0, 4)) seen.add(k);
  for (const k of seen)
    if (!isCut(scene.places[k])) write(scene.places[k], String(scene.pointAt[k]), 12, colours.inkText);
};

