// SPDX-License-Identifier: Apache-2.0
// The model: vertices, edges that every view has, and folds, which are drawn where they are contours.
// tools/serve/wireframe.hpp describes the bytes.

const wireframeOf = buffer => {
  const [vertices, lines, folds] = new Uint32Array(buffer, 0, 3);
  const afterVertices = 16 + 24 * vertices;
  return {
    vertices: new Float64Array(buffer, 16, 3 * vertices),
    lines: new Int32Array(buffer, afterVertices, 2 * lines),
    folds: new Int32Array(buffer, afterVertices + 8 * lines, 4 * folds),
  };
};

// Each vertex on the page, homogeneous (x, y, w), and its depth n in view reference coordinates.
const mapped = ({vertices}, steps) => {
  const m = productOf(steps), vom = steps[0][1], count = vertices.length / 3;
  const page = new Float64Array(3 * count), depth = new Float64Array(count);
  for (let i = 0; i < count; ++i) {
    const x = vertices[3 * i], y = vertices[3 * i + 1], z = vertices[3 * i + 2];
    page[3 * i] = m[0] * x + m[1] * y + m[2] * z + m[3];
    page[3 * i + 1] = m[4] * x + m[5] * y + m[6] * z + m[7];
    page[3 * i + 2] = m[12] * x + m[13] * y + m[14] * z + m[15];
    depth[i] = vom[8] * x + vom[9] * y + vom[10] * z + vom[11];
  }
  return {page, depth};
};

// Whether both triangles of a fold are on one side of its edge. Without divisions, so that it holds behind the viewer,
// too.
const isContour = (page, folds, at) => {
  const a = 3 * folds[at], b = 3 * folds[at + 1];
  const nx = page[a + 1] * page[b + 2] - page[a + 2] * page[b + 1];
  const ny = page[a + 2] * page[b] - page[a] * page[b + 2];
  const nw = page[a] * page[b + 1] - page[a + 1] * page[b];
  const side = c => nx * page[c] + ny * page[c + 1] + nw * page[c + 2];
  return side(3 * folds[at + 2]) * side(3 * folds[at + 3]) > 0;
};

// Calls `draw(x, y, x, y)` for each edge of the view, between the front and the back plane, in mm of the page.
const eachLine = (model, {page, depth}, view, draw) => {
  const slack = 1e-9 * (view.F - view.B), front = view.F + slack, back = view.B - slack;
  const isWithin = vertex => depth[vertex] <= front && depth[vertex] >= back;
  const segment = (a, b) => {
    if (isWithin(a) && isWithin(b)) {
      const i = 3 * a, k = 3 * b;
      draw(page[i] / page[i + 2], page[i + 1] / page[i + 2], page[k] / page[k + 2], page[k + 1] / page[k + 2]);
      return;
    }
    let from = 0, to = 1;
    const rise = depth[b] - depth[a];
    for (const [limit, sign] of [[front, 1], [back, -1]]) {
      const beyondA = sign * (depth[a] - limit) > 0, beyondB = sign * (depth[b] - limit) > 0;
      if (beyondA && beyondB) return;
      if (beyondA) from = Math.max(from, (limit - depth[a]) / rise);
      if (beyondB) to = Math.min(to, (limit - depth[a]) / rise);
    }
    if (from > to) return;
    const at = (t, row) => (1 - t) * page[3 * a + row] + t * page[3 * b + row];
    const w = at(from, 2), v = at(to, 2);
    draw(at(from, 0) / w, at(from, 1) / w, at(to, 0) / v, at(to, 1) / v);
  };
  const {lines, folds} = model;
  for (let i = 0; i < lines.length; i += 2) segment(lines[i], lines[i + 1]);
  for (let i = 0; i < folds.length; i += 4) if (isContour(page, folds, i)) segment(folds[i], folds[i + 1]);
};

// Paints on a canvas that shows the whole sheet. The projection may limit the window.
const paint = (canvas, model, points, view) => {
  const [width, height] = view.paper, scale = canvas.width / width, context = canvas.getContext('2d');
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.save();
  const [left, low, right, high] = view.viewport;
  context.beginPath();
  context.rect((left - 1) * scale, (height - high - 1) * scale, (right - left + 2) * scale, (high - low + 2) * scale);
  context.clip();
  context.strokeStyle = '#000';
  context.lineWidth = Math.max(1, 0.25 * scale);
  // One path of very many lines takes far longer than many paths.
  let lines = 0;
  context.beginPath();
  eachLine(model, points, view, (x, y, u, v) => {
    context.moveTo(x * scale, (height - y) * scale);
    context.lineTo(u * scale, (height - v) * scale);
    if (++lines % 256 !== 0) return;
    context.stroke();
    context.beginPath();
  });
  context.stroke();
  context.restore();
};
