// SPDX-License-Identifier: Apache-2.0
// Large drawings: lines as arrays of numbers, painted on a canvas.

// Base64 of little-endian floats.
function unpackFloats(text) {
  const packed = atob(text), bytes = new Uint8Array(packed.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = packed.charCodeAt(i);
  return new Float32Array(bytes.buffer);
}

// Base64 of integers with seven bits in a byte, the lowest first, and 128 in all but the last; the lowest bit of all is
// the sign.
function unpackIntegers(text) {
  const packed = atob(text), integers = new Int32Array(packed.length);
  let count = 0, value = 0, shift = 0;
  for (let i = 0; i < packed.length; ++i) {
    const byte = packed.charCodeAt(i);
    value |= (byte & 127) << shift;
    shift += 7;
    if (byte > 127) continue;
    integers[count++] = value & 1 ? ~(value >>> 1) : value >>> 1;
    value = shift = 0;
  }
  return integers.subarray(0, count);
}

// A layer: its lines one after another. What is only told of single lines is unpacked when it is first asked for.
class PackedLayer {
  constructor(packed, group, first) {
    Object.assign(this, {group, first, packed, width: packed.width, colour: packed.colour, dashes: packed.dashes});
    const steps = unpackIntegers(packed.points), heads = unpackIntegers(packed.heads);
    this.points = new Float32Array(steps.length);
    for (let i = 0, x = 0, y = 0; i < steps.length; i += 2) {
      this.points[i] = (x += steps[i]) / 1e4;
      this.points[i + 1] = (y += steps[i + 1]) / 1e4;
    }
    this.kinds = unpackIntegers(packed.kinds);
    this.count = heads.length;
    this.start = new Uint32Array(this.count + 1);  // of each line in `points`
    this.closed = new Uint8Array(this.count);
    this.whole = new Uint8Array(this.count);  // not dashed
    this.boxes = new Float32Array(4 * this.count);
    for (let i = 0; i < this.count; ++i) {
      this.closed[i] = heads[i] & 1;
      this.whole[i] = heads[i] >> 1 & 1;
      this.start[i + 1] = this.start[i] + 2 * (heads[i] >>> 2);
      this.setBox(i);
    }
  }

  setBox(i) {
    let x0 = Infinity, y0 = Infinity, x1 = -Infinity, y1 = -Infinity;
    for (let at = this.start[i]; at < this.start[i + 1]; at += 2) {
      const x = this.points[at], y = this.points[at + 1];
      if (x < x0) x0 = x;
      if (x > x1) x1 = x;
      if (y < y0) y0 = y;
      if (y > y1) y1 = y;
    }
    const box = 4 * i;
    this.boxes[box] = x0;
    this.boxes[box + 1] = y0;
    this.boxes[box + 2] = x1;
    this.boxes[box + 3] = y1;
  }

  get isShown() { return !this.group.closest('[hidden]'); }

  get facts() {
    if (!this.known) {
      const {packed} = this, edgeStart = new Uint32Array(this.count + 1), faceStart = new Uint32Array(this.count + 1);
      const edgeCounts = unpackIntegers(packed.edgeCounts), edges = unpackIntegers(packed.edges), faces = unpackIntegers(packed.faces);
      for (let i = 0, last = 0; i < edges.length; i += 3) {
        last = edges[i + 1] += last;
        edges[i + 2] += last;
      }
      for (let i = 0, at = 0, last = 0; i < this.count; ++i) {
        edgeStart[i + 1] = edgeStart[i] + 3 * edgeCounts[i];
        at += 2;
        for (let left = Math.min(2, faces[at - 2]); left > 0; --left) last = faces[at++] += last;
        faceStart[i + 1] = at;
      }
      this.known = {edgeStart, edges, faceStart, faces, lengths: unpackFloats(packed.lengths), depths: unpackFloats(packed.depths)};
      this.packed = null;
    }
    return this.known;
  }
}

// The lines of a sheet that are in arrays.
class PackedLines extends SheetLines {
  constructor(svg, data, packed) {
    super(svg, data);
    const groups = [...svg.querySelectorAll('g[data-layer]')];
    const groupOf = ({view, layer}) => groups.find(group =>
      group.dataset.layer === layer && (group.closest('[data-view]')?.dataset.view ?? '') === view);
    this.kindNames = packed.kinds;
    this.hiddenKinds = new Set();
    this.centred = [];
    this.layers = [];
    this.count = 0;
    for (const layer of packed.layers) {
      this.layers.push(new PackedLayer(layer, groupOf(layer), this.count));
      this.count += this.layers[this.layers.length - 1].count;
    }
  }

  // The layer of a line, and its number there.
  at(number) {
    let low = 0, high = this.layers.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.layers[middle].first <= number) low = middle;
      else high = middle - 1;
    }
    return {layer: this.layers[low], i: number - this.layers[low].first};
  }

  line(number) {
    const {layer, i} = this.at(number), points = layer.points.subarray(layer.start[i], layer.start[i + 1]);
    return {points, closed: layer.closed[i] === 1, centres: [], get corners() { return [...Array(points.length / 2).keys()]; }};
  }

  isShown(number) {
    const {layer, i} = this.at(number);
    return !this.hiddenKinds.has(layer.kinds[i]) && layer.isShown;
  }

  layerOf(number) { return this.at(number).layer.group; }

  depths(number) {
    const {layer, i} = this.at(number), [first, last] = layer.facts.depths.subarray(2 * i, 2 * i + 2);
    return Number.isNaN(first) ? [] : first === last ? [first] : [first, last];
  }

  origin(number) {
    const {layer, i} = this.at(number), {edgeStart, edges, faceStart, faces, lengths} = layer.facts, names = [];
    for (let at = edgeStart[i]; at < edgeStart[i + 1]; at += 3) names.push(`${edges[at + 1]}-${edges[at + 2]}`);
    const [all, body, ...first] = faces.subarray(faceStart[i], faceStart[i + 1]);
    return {kind: this.kindNames[layer.kinds[i]], model: names.length > 0 ? edges[edgeStart[i]] : NaN, edges: names, body,
            faces: first, moreFaces: all - first.length, length: names.length > 0 ? lengths[i] : null};
  }

  get kinds() {
    const counts = new Map();
    for (const {kinds} of this.layers)
      for (const kind of kinds) counts.set(this.kindNames[kind], (counts.get(this.kindNames[kind]) ?? 0) + 1);
    return counts;
  }

  isKindShown(kind) { return !this.hiddenKinds.has(this.kindNames.indexOf(kind)); }
  showKind(kind, on) { this.hiddenKinds[on ? 'delete' : 'add'](this.kindNames.indexOf(kind)); }
}

const tileSize = 512;  // pixels

// Paints what is seen of packed lines. A tile is painted a few lines at a time, so that no frame is late; until it is
// ready, an older picture of it at another scale is shown.
class Painter {
  constructor(section, lines) {
    this.lines = lines;
    this.canvas = section.insertBefore(document.createElement('canvas'), section.firstChild);
    this.canvas.className = 'lines';
    this.canvas.setAttribute('aria-hidden', 'true');
    this.context = this.canvas.getContext('2d', {alpha: false});
    this.tiles = new Map();
    this.old = null;
  }

  // Everything is to be painted again: other layers or colours.
  renew() {
    this.tiles.clear();
    this.old = null;
    this.overview = null;
  }

  // Paints a frame; returns whether there is more to paint.
  paint({x, y, scale, size: {width, height}}) {
    const ratio = window.devicePixelRatio || 1, pixels = scale * ratio;
    if (this.canvas.width !== Math.round(width * ratio) || this.canvas.height !== Math.round(height * ratio)) {
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(height * ratio);
    }
    if (this.scale !== pixels) {
      if (this.scale && [...this.tiles.values()].some(tile => tile.done)) this.old = {tiles: this.tiles, scale: this.scale};
      this.tiles = new Map();
      this.scale = pixels;
    }
    const seen = this.seenTiles(x * pixels, y * pixels);
    const until = performance.now() + 10;
    for (const tile of seen) while (!tile.done && performance.now() < until) this.advance(tile);
    this.compose(x * pixels, y * pixels, seen);
    this.forget(seen);
    return seen.some(tile => !tile.done);
  }

  // The tiles in sight, from the middle outwards.
  seenTiles(left, top) {
    const seen = [], right = left + this.canvas.width, bottom = top + this.canvas.height;
    const endX = this.lines.data.width * this.scale, endY = this.lines.data.height * this.scale;
    for (let row = Math.floor(Math.max(0, top) / tileSize); row * tileSize < Math.min(bottom, endY); ++row)
      for (let column = Math.floor(Math.max(0, left) / tileSize); column * tileSize < Math.min(right, endX); ++column) {
        const key = `${column} ${row}`;
        if (!this.tiles.has(key)) this.tiles.set(key, {key, column, row, layer: 0, line: 0, done: false});
        seen.push(this.tiles.get(key));
      }
    const away = tile => Math.hypot((tile.column + 0.5) * tileSize - (left + right) / 2, (tile.row + 0.5) * tileSize - (top + bottom) / 2);
    return seen.sort((a, b) => away(a) - away(b));
  }

  // Paints the next lines of a tile.
  advance(tile) {
    const {layers} = this.lines;
    if (!tile.canvas) {
      tile.canvas = document.createElement('canvas');
      tile.canvas.width = tile.canvas.height = tileSize;
      tile.context = tile.canvas.getContext('2d', {willReadFrequently: true});
      tile.context.setTransform(this.scale, 0, 0, this.scale, -tile.column * tileSize, -tile.row * tileSize);
    }
    if (tile.layer >= layers.length) {
      tile.done = true;
      return;
    }
    const layer = layers[tile.layer];
    if (tile.line < layer.count && layer.isShown) {
      const length = tileSize / this.scale;
      tile.line = this.paintLines(tile.context, layer, tile.line, 1500,
                                  {x: tile.column * length, y: tile.row * length, width: length, height: length});
      tile.context.getImageData(0, 0, 1, 1);  // paints now, so that the clock tells what it took
    } else {
      tile.line = layer.count;
    }
    if (tile.line < layer.count) return;
    ++tile.layer;
    tile.line = 0;
  }

  // Paints lines of a layer that may be in a box, from a number on, `most` of them; returns the next number.
  paintLines(context, layer, from, most, box) {
    const {boxes, points, start, closed, kinds, whole} = layer, reach = layer.width;
    const x0 = box.x - reach, y0 = box.y - reach, x1 = box.x + box.width + reach, y1 = box.y + box.height + reach;
    const paths = [new Path2D(), new Path2D()];  // dashed, and not
    let painted = 0, i = from;
    for (; i < layer.count && painted < most; ++i) {
      const b = 4 * i;
      if (boxes[b] > x1 || boxes[b + 2] < x0 || boxes[b + 1] > y1 || boxes[b + 3] < y0) continue;
      if (this.lines.hiddenKinds.has(kinds[i])) continue;
      const path = paths[whole[i]];
      path.moveTo(points[start[i]], points[start[i] + 1]);
      for (let at = start[i] + 2; at < start[i + 1]; at += 2) path.lineTo(points[at], points[at + 1]);
      if (closed[i]) path.closePath();
      painted += (start[i + 1] - start[i]) / 2;
    }
    context.lineWidth = layer.width;
    context.lineCap = context.lineJoin = 'round';
    context.strokeStyle = this.dark && layer.colour === '#000000' ? '#ededed' : layer.colour;
    context.setLineDash(layer.dashes);
    context.stroke(paths[0]);
    context.setLineDash([]);
    context.stroke(paths[1]);
    return i;
  }

  compose(left, top, seen) {
    const {context, canvas, scale, lines: {data}} = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = getComputedStyle(canvas).backgroundColor;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.fillStyle = this.dark ? '#121212' : '#fff';
    context.fillRect(-left, -top, data.width * scale, data.height * scale);
    if (this.old && seen.some(tile => !tile.done)) {
      const by = scale / this.old.scale;
      for (const tile of this.old.tiles.values())
        if (tile.canvas)
          context.drawImage(tile.canvas, tile.column * tileSize * by - left, tile.row * tileSize * by - top, tileSize * by, tileSize * by);
    } else if (this.old) {
      this.old = null;
    }
    const shift = at => Math.round(at);
    for (const tile of seen) {
      if (!tile.canvas) continue;
      const x = shift(tile.column * tileSize - left), y = shift(tile.row * tileSize - top);
      if (this.old && tile.done) {
        context.fillStyle = this.dark ? '#121212' : '#fff';
        context.fillRect(x, y, Math.min(tileSize, data.width * scale - tile.column * tileSize),
                         Math.min(tileSize, data.height * scale - tile.row * tileSize));
      }
      context.drawImage(tile.canvas, x, y);
    }
  }

  // Keeps some tiles out of sight, the latest ones.
  forget(seen) {
    const most = 3 * seen.length + 24;
    for (const tile of seen) {
      this.tiles.delete(tile.key);
      this.tiles.set(tile.key, tile);
    }
    for (const key of this.tiles.keys()) {
      if (this.tiles.size <= most) break;
      this.tiles.delete(key);
    }
  }

  // The whole sheet for a printer, at 300 dots per inch or as many as fit.
  print() {
    const {width, height} = this.lines.data, pixels = Math.min(300 / 25.4, 8000 / Math.max(width, height));
    this.canvas.width = Math.round(width * pixels);
    this.canvas.height = Math.round(height * pixels);
    const {context} = this, dark = this.dark;
    context.fillStyle = '#fff';
    context.fillRect(0, 0, this.canvas.width, this.canvas.height);
    context.setTransform(pixels, 0, 0, pixels, 0, 0);
    this.dark = false;
    for (const layer of this.lines.layers)
      if (layer.isShown) this.paintLines(context, layer, 0, Infinity, {x: 0, y: 0, width, height});
    this.dark = dark;
  }
}
