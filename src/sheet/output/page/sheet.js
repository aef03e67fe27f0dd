// SPDX-License-Identifier: Apache-2.0
// The lines of a sheet, where they come from, and what can be measured on them.

// The inverse of a 4 x 4 matrix by rows (Gauss and Jordan); null if there is none.
function inverted(matrix) {
  const rows = [0, 1, 2, 3].map(r => [...matrix.slice(4 * r, 4 * r + 4), ...[0, 1, 2, 3].map(c => Number(r === c))]);
  for (let c = 0; c < 4; ++c) {
    let best = c;
    for (let r = c + 1; r < 4; ++r) if (Math.abs(rows[r][c]) > Math.abs(rows[best][c])) best = r;
    if (!(Math.abs(rows[best][c]) > 0)) return null;
    [rows[c], rows[best]] = [rows[best], rows[c]];
    rows[c] = rows[c].map(value => value / rows[c][c]);
    for (let r = 0; r < 4; ++r) if (r !== c) rows[r] = rows[r].map((value, i) => value - rows[r][c] * rows[c][i]);
  }
  return rows.map(row => row.slice(4));
}

// Whether a view looks along an axis of the world, at right angles to the page.
function isPrincipal({central, matrix}) {
  const shownAxes = row => [0, 1, 2].filter(c => Math.abs(matrix[4 * row + c]) > 1e-9 * Math.hypot(...matrix.slice(4 * row, 4 * row + 3)));
  return !central && shownAxes(0).length === 1 && shownAxes(1).length === 1;
}

const numbersOf = text => (text || '').split(' ').filter(Boolean).map(Number);

// With no more decimals than are known.
function shown(value, decimals = 12) {
  const rounded = Number(Number(value.toPrecision(6)).toFixed(decimals));
  return String(rounded === 0 ? 0 : rounded);
}

// Positions on the page are rounded to 0.0001 mm.
const decimalsOf = view => Math.min(12, Math.max(0, Math.round(3 + Math.log10(view.scale))));

// The lines of a sheet, by number. Where they come from is told by SvgLines and PackedLines: `count`, `line`, `centred`
// (those with centres), `isShown`, `layerOf`, `origin`, `depths`, `kinds` and `showKind`.
class SheetLines {
  constructor(svg, data) {
    Object.assign(this, {svg, data});
    this.views = new Map(data.views.map(view =>
      [view.name, {...view, inverse: inverted(view.matrix), principal: isPrincipal(view)}]));
  }

  get grid() { return this.gridOfLines ??= this.makeGrid(); }

  makeGrid() {
    let size = 0;
    const each = visit => {
      for (let number = 0; number < this.count; ++number) {
        const {points, closed} = this.line(number), end = points.length;
        for (let i = 0; i + 3 < end; i += 2) visit(number, points[i], points[i + 1], points[i + 2], points[i + 3]);
        if (closed && end >= 4) visit(number, points[end - 2], points[end - 1], points[0], points[1]);
      }
    };
    each(() => { ++size; });
    const segments = new Float32Array(4 * size), lines = new Uint32Array(size);
    let at = 0;
    each((number, x0, y0, x1, y1) => {
      segments[4 * at] = x0;
      segments[4 * at + 1] = y0;
      segments[4 * at + 2] = x1;
      segments[4 * at + 3] = y1;
      lines[at++] = number;
    });
    return new LineGrid(segments, lines, this.data.width, this.data.height);
  }

  near(x, y, radius) { return this.grid.near(x, y, radius, number => this.isShown(number)); }
  viewOf(number) { return this.views.get(this.layerOf(number).closest('[data-view]')?.dataset.view); }

  // Path data of a line, for marks on it.
  pathOf(number) {
    const {points, closed} = this.line(number);
    return `M${Array.from(points).join(' ')}${closed ? 'Z' : ''}`;
  }

  // What is known of a line.
  facts(number) {
    const layer = this.layerOf(number), origin = this.origin(number), known = this.data.models[origin.model];
    const hasBody = known?.bodies.length === 1 || origin.faces.length > 0;
    return {...origin, view: this.viewOf(number)?.name ?? '', layer: layer.dataset.layer,
            visible: layer.dataset.visible === '1', modelName: known?.name ?? '',
            body: hasBody && known?.bodies[known.bodies.length === 1 ? 0 : origin.body] || ''};
  }

  // The depth of a position on a line; null if it is not known. One number: the same everywhere; two: those of the
  // ends; three: a plane, a x + b y + c, y up; more: those of the corners.
  depth(number, point, corner) {
    const depths = this.depths(number);
    if (depths.length === 0) return null;
    if (depths.length === 1) return depths[0];
    if (depths.length === 3) return depths[0] * point.x + depths[1] * (this.data.height - point.y) + depths[2];
    return depths[corner] ?? null;
  }

  // The ends, corners and centres of a line.
  marks(number) {
    const {points, corners, centres, closed} = this.line(number), marks = [];
    const add = (point, name, corner) => {
      marks.push({...point, name, line: number, view: this.viewOf(number), depth: this.depth(number, point, corner)});
    };
    corners.forEach((at, i) => {
      const isEnd = !closed && (i === 0 || i === corners.length - 1);
      if (isEnd || centres.length === 0) add({x: points[2 * at], y: points[2 * at + 1]}, isEnd ? 'end' : 'corner', i);
    });
    for (const centre of centres) add(centre, 'centre', -1);
    return marks;
  }

  // The mark nearest to a position: of lines there, or the centre of any line.
  nearestMark(x, y, radius) {
    let best = null, least = radius;
    const ask = mark => {
      const distance = Math.hypot(mark.x - x, mark.y - y);
      if (distance < least) [best, least] = [mark, distance];
    };
    for (const number of this.near(x, y, radius)) this.marks(number).forEach(ask);
    for (const number of this.centred) {
      if (!this.line(number).centres.some(at => Math.hypot(at.x - x, at.y - y) < least)) continue;
      if (this.isShown(number)) this.marks(number).filter(mark => mark.name === 'centre').forEach(ask);
    }
    return best;
  }

  // A position in units of the world; null if it is not known.
  world(mark) {
    const inverse = mark.view?.inverse;
    if (!inverse || mark.depth === null || mark.view.broken) return null;
    const page = [mark.x, this.data.height - mark.y, mark.depth, 1];
    const [x, y, z, w] = inverse.map(row => row.reduce((sum, value, i) => sum + value * page[i], 0));
    return [x / w, y / w, z / w];
  }

  // The distance between two marks in sentences. A line of a principal view stands for all edges behind each other,
  // whose depths differ: distances are measured in its plane. Elsewhere, they are measured in space.
  measure(from, to) {
    const a = this.world(from), b = this.world(to), view = from.view;
    const decimals = Math.min(...[from, to].map(mark => decimalsOf(mark.view)));
    const told = (by, names, where) => {
      const length = Math.hypot(...by);
      return {length, text: `${shown(length, decimals)} ${where}`,
              parts: by.map((value, i) => `${names[i]} ${shown(value, decimals)}`)};
    };
    if (a && b && !(view === to.view && view.principal)) return told(b.map((value, i) => value - a[i]), ['Δx', 'Δy', 'Δz'], 'in space');
    const not = text => ({length: null, text, parts: []});
    if (view !== to.view) return not('the ends are in different views');
    if (view.broken) return not('distances in a broken view are not true');
    if (view.central) return not('a perspective has no scale');
    return told([(to.x - from.x) / view.scale, (from.y - to.y) / view.scale], ['across', 'up'], 'in the plane of the view');
  }
}

// The lines of a sheet that are elements of its picture.
class SvgLines extends SheetLines {
  constructor(svg, data) {
    super(svg, data);
    this.nodes = [...svg.querySelectorAll('path[data-kind]')];
    this.lines = this.nodes.map(node => parsePath(node.getAttribute('d')));
    this.centred = [...this.lines.keys()].filter(number => this.lines[number].centres.length > 0);
  }

  get count() { return this.nodes.length; }
  line(number) { return this.lines[number]; }
  isShown(number) { return !this.nodes[number].closest('[hidden]'); }
  layerOf(number) { return this.nodes[number].closest('[data-layer]'); }
  pathOf(number) { return this.nodes[number].getAttribute('d'); }
  about(number) { return (this.nodes[number].dataset.about ?? '').split(';'); }
  depths(number) { return numbersOf(this.about(number)[3]); }

  origin(number) {
    const {dataset} = this.nodes[number], [length, allFaces = '', body] = this.about(number);
    const [, faces, more] = /^([^+]*)(.*)$/.exec(allFaces);
    return {kind: dataset.kind, model: Number(dataset.model ?? this.layerOf(number).dataset.model ?? NaN),
            edges: (dataset.edge ?? '').split(' ').filter(Boolean), body: Number(body || 0),
            faces: numbersOf(faces), moreFaces: Number(more || 0), length: length === '' ? null : Number(length)};
  }

  // How many lines of each kind there are.
  get kinds() {
    const counts = new Map();
    for (const {dataset: {kind}} of this.nodes) counts.set(kind, (counts.get(kind) ?? 0) + 1);
    return counts;
  }

  isKindShown(kind) { return !this.nodes.find(node => node.dataset.kind === kind).hasAttribute('hidden'); }
  showKind(kind, on) {
    for (const node of this.nodes) if (node.dataset.kind === kind) node.toggleAttribute('hidden', !on);
  }
}
