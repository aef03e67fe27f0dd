// SPDX-License-Identifier: Apache-2.0
// Lines of a drawing as points in millimetres of the sheet, y down, and a grid that finds them by position.

const stepsOfArc = 12;  // an arc is a quarter of an ellipse at most

// SVG 2, B.2.4: from the ends of an arc, never the larger one, to its centre.
function arcOf(from, [rx, ry, turn, , sweep, toX, toY]) {
  const cos = Math.cos(turn * Math.PI / 180), sin = Math.sin(turn * Math.PI / 180);
  const dx = (from.x - toX) / 2, dy = (from.y - toY) / 2;
  const x = cos * dx + sin * dy, y = cos * dy - sin * dx;
  const grow = Math.max(1, Math.hypot(x / rx, y / ry));
  rx *= grow;
  ry *= grow;
  const beyond = (rx * ry) ** 2 / ((rx * y) ** 2 + (ry * x) ** 2) - 1;
  const factor = Math.sqrt(Math.max(0, beyond)) * (sweep ? 1 : -1);
  const u = factor * rx * y / ry, v = -factor * ry * x / rx;
  const first = Math.atan2((y - v) / ry, (x - u) / rx);
  let by = Math.atan2((-y - v) / ry, (-x - u) / rx) - first;
  if (sweep && by < 0) by += 2 * Math.PI;
  if (!sweep && by > 0) by -= 2 * Math.PI;
  const centre = {x: cos * u - sin * v + (from.x + toX) / 2, y: sin * u + cos * v + (from.y + toY) / 2};
  return {centre, at: part => {
    const a = first + part * by, p = rx * Math.cos(a), q = ry * Math.sin(a);
    return {x: centre.x + cos * p - sin * q, y: centre.y + sin * p + cos * q};
  }};
}

// The centre of a circle or an ellipse that is drawn with straight lines: every corner has another one opposite. Null for
// other lines.
function centreOfPolygon(points) {
  const count = points.length / 2, half = points.length / 2;
  if (count < 12 || count % 2 === 1) return null;
  const centre = {x: (points[0] + points[half]) / 2, y: (points[1] + points[half + 1]) / 2};
  for (let i = 0; i < half; i += 2) {
    const away = Math.hypot((points[i] + points[i + half]) / 2 - centre.x, (points[i + 1] + points[i + half + 1]) / 2 - centre.y);
    if (away > 2e-3) return null;
  }
  return centre;
}

// The path data of one line, as epura writes it: M, then h, v, l, A and Z.
function parsePath(text) {
  const line = {points: [], corners: [], centres: [], closed: false};
  const tokens = text.match(/[a-zA-Z]|-?(?:\d+\.?\d*|\.\d+)/g) || [];
  let at = {x: 0, y: 0}, command = '';
  const add = point => {
    at = point;
    line.points.push(at.x, at.y);
  };
  for (let i = 0; i < tokens.length;) {
    if (/[a-zA-Z]/.test(tokens[i])) command = tokens[i++];
    const take = count => tokens.slice(i, i += count).map(Number);
    if (command === 'Z') {
      line.closed = true;
      continue;
    } else if (command === 'M') {
      const [x, y] = take(2);
      add({x, y});
    } else if (command === 'h') {
      add({x: at.x + take(1)[0], y: at.y});
    } else if (command === 'v') {
      add({x: at.x, y: at.y + take(1)[0]});
    } else if (command === 'l') {
      const [x, y] = take(2);
      add({x: at.x + x, y: at.y + y});
    } else if (command === 'A') {
      const numbers = take(7), arc = arcOf(at, numbers);
      for (let step = 1; step < stepsOfArc; ++step) add(arc.at(step / stepsOfArc));
      add({x: numbers[5], y: numbers[6]});
      const last = line.centres[line.centres.length - 1];
      if (!last || Math.hypot(last.x - arc.centre.x, last.y - arc.centre.y) > 1e-3) line.centres.push(arc.centre);
    } else {
      break;
    }
    line.corners.push(line.points.length / 2 - 1);
  }
  const centre = line.closed && line.centres.length === 0 ? centreOfPolygon(line.points) : null;
  if (centre) line.centres.push(centre);
  return line;
}

// The position on a segment nearest to a point, and its distance.
function nearestOnSegment(x, y, x0, y0, x1, y1) {
  const dx = x1 - x0, dy = y1 - y0, square = dx * dx + dy * dy;
  const t = square > 0 ? Math.min(1, Math.max(0, ((x - x0) * dx + (y - y0) * dy) / square)) : 0;
  return Math.hypot(x - x0 - t * dx, y - y0 - t * dy);
}

// Cells of the sheet with the segments whose boxes meet them, in one array: those of cell c are
// [first[c], first[c + 1]). `segments` holds x0, y0, x1, y1 for each, `lines` the number of its line.
class LineGrid {
  constructor(segments, lines, width, height) {
    this.segments = segments;
    this.lines = lines;
    this.cell = Math.max(1, Math.sqrt(width * height / Math.max(400, Math.min(40000, lines.length))));
    this.columns = Math.ceil(width / this.cell) + 1;
    this.rows = Math.ceil(height / this.cell) + 1;
    this.first = new Uint32Array(this.columns * this.rows + 1);
    for (let i = 0; i < lines.length; ++i) this.eachCell(i, cell => { ++this.first[cell + 1]; });
    for (let c = 1; c < this.first.length; ++c) this.first[c] += this.first[c - 1];
    this.items = new Uint32Array(this.first[this.first.length - 1]);
    const next = this.first.slice();
    for (let i = 0; i < lines.length; ++i) this.eachCell(i, cell => { this.items[next[cell]++] = i; });
  }

  column(x) { return Math.min(this.columns - 1, Math.max(0, Math.floor(x / this.cell))); }
  row(y) { return Math.min(this.rows - 1, Math.max(0, Math.floor(y / this.cell))); }

  cellsOfBox(x0, y0, x1, y1, visit) {
    const left = this.column(Math.min(x0, x1)), right = this.column(Math.max(x0, x1));
    const top = this.row(Math.min(y0, y1)), bottom = this.row(Math.max(y0, y1));
    for (let row = top; row <= bottom; ++row)
      for (let column = left; column <= right; ++column) visit(row * this.columns + column);
  }

  eachCell(segment, visit) {
    const s = this.segments, i = 4 * segment;
    this.cellsOfBox(s[i], s[i + 1], s[i + 2], s[i + 3], visit);
  }

  // The numbers of the lines within `radius`, nearest first.
  near(x, y, radius, accept) {
    const found = new Map(), s = this.segments;
    this.cellsOfBox(x - radius, y - radius, x + radius, y + radius, cell => {
      for (let at = this.first[cell]; at < this.first[cell + 1]; ++at) {
        const segment = this.items[at], line = this.lines[segment], i = 4 * segment;
        if (!accept(line)) continue;
        const distance = nearestOnSegment(x, y, s[i], s[i + 1], s[i + 2], s[i + 3]);
        if (distance <= radius && !(found.get(line) <= distance)) found.set(line, distance);
      }
    });
    return [...found].sort((a, b) => a[1] - b[1] || a[0] - b[0]).map(([line]) => line);
  }
}
