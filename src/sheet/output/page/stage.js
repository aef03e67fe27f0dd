// SPDX-License-Identifier: Apache-2.0
// Moves and scales what is seen of a sheet, by mouse, touch and keyboard.

class Stage {
  // `seen` is called when the part that is seen changes; `hover` and `pick` with a position on the sheet.
  constructor(element, width, height, {seen, hover, pick}) {
    Object.assign(this, {element, width, height, seen, hover, pick});
    this.pointers = new Map();
    this.moved = 0;
    this.x = this.y = 0;
    this.scale = 1;  // pixels per millimetre
    const on = (name, act) => element.addEventListener(name, event => this.active !== false && act(event));
    on('pointerdown', event => this.pointerDown(event));
    on('pointermove', event => this.pointerMove(event));
    for (const name of ['pointerup', 'pointercancel']) on(name, event => this.pointerUp(event));
    on('pointerleave', () => this.hover(null));
    element.addEventListener('wheel', event => this.active !== false && this.wheel(event), {passive: false});
    on('dblclick', event => this.zoom(event.shiftKey ? 0.5 : 2, event.clientX, event.clientY));
    on('keydown', event => this.keyDown(event));
    new ResizeObserver(() => this.active !== false && this.resized()).observe(element);
  }

  get size() { return {width: this.element.clientWidth || 1, height: this.element.clientHeight || 1}; }

  fit() {
    const {width, height} = this.size;
    this.scale = Math.min(width / this.width, height / this.height) * 0.98;
    this.x = (this.width - width / this.scale) / 2;
    this.y = (this.height - height / this.scale) / 2;
    this.fitted = true;
    this.changed();
  }

  resized() {
    if (this.fitted !== false) this.fit();
    else this.changed();
  }

  changed() {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.seen();
    });
  }

  toSheet(clientX, clientY) {
    const box = this.element.getBoundingClientRect();
    return {x: this.x + (clientX - box.left) / this.scale, y: this.y + (clientY - box.top) / this.scale};
  }

  // `dx`, `dy` in pixels. Some of the sheet stays in sight.
  move(dx, dy) {
    const {width, height} = this.size;
    const keep = (at, length, pixels) => Math.min(length, Math.max(-pixels / this.scale, at));
    this.x = keep(this.x - dx / this.scale, this.width, width);
    this.y = keep(this.y - dy / this.scale, this.height, height);
    this.fitted = false;
    this.changed();
  }

  zoom(by, clientX, clientY) {
    const box = this.element.getBoundingClientRect();
    if (clientX === undefined) clientX = box.left + box.width / 2;
    if (clientY === undefined) clientY = box.top + box.height / 2;
    const fixed = this.toSheet(clientX, clientY);
    this.scale = Math.min(2000, Math.max(0.05, this.scale * by));
    this.x = fixed.x - (clientX - box.left) / this.scale;
    this.y = fixed.y - (clientY - box.top) / this.scale;
    this.fitted = false;
    this.changed();
  }

  // Brings a box of the sheet into sight, if it is not.
  show({x0, y0, x1, y1}) {
    const {width, height} = this.size, w = width / this.scale, h = height / this.scale;
    if (x0 >= this.x && y0 >= this.y && x1 <= this.x + w && y1 <= this.y + h) return;
    this.scale = Math.min(this.scale, 0.8 * Math.min(width / Math.max(x1 - x0, 1e-3), height / Math.max(y1 - y0, 1e-3)));
    this.x = (x0 + x1 - width / this.scale) / 2;
    this.y = (y0 + y1 - height / this.scale) / 2;
    this.fitted = false;
    this.changed();
  }

  pointerDown(event) {
    if (event.button > 1) return;
    this.element.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    if (this.pointers.size === 1) this.moved = 0;
  }

  pointerMove(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) {
      this.hover(this.toSheet(event.clientX, event.clientY));
      return;
    }
    const now = {x: event.clientX, y: event.clientY};
    const others = [...this.pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    this.moved += Math.hypot(now.x - before.x, now.y - before.y) + others.length;
    if (this.moved > 4) {
      if (others.length === 1) {
        const [other] = others, length = at => Math.max(1, Math.hypot(at.x - other.x, at.y - other.y));
        this.zoom(length(now) / length(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
      }
      this.move((now.x - before.x) / (others.length + 1), (now.y - before.y) / (others.length + 1));
    }
    this.pointers.set(event.pointerId, now);
  }

  pointerUp(event) {
    if (!this.pointers.delete(event.pointerId)) return;
    if (event.type === 'pointerup' && this.pointers.size === 0 && this.moved <= 4)
      this.pick(this.toSheet(event.clientX, event.clientY), event.pointerType);
  }

  wheel(event) {
    if (this.wheelNeedsKey && !event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    const pixels = event.deltaY * (event.deltaMode === 1 ? 16 : 1);
    this.zoom(Math.exp(-Math.min(300, Math.max(-300, pixels)) / 400), event.clientX, event.clientY);
  }

  keyDown(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const step = event.shiftKey ? 200 : 50;
    const acts = {
      ArrowLeft: () => this.move(step, 0), ArrowRight: () => this.move(-step, 0),
      ArrowUp: () => this.move(0, step), ArrowDown: () => this.move(0, -step),
      '+': () => this.zoom(1.25), '=': () => this.zoom(1.25), '-': () => this.zoom(0.8), '0': () => this.fit(),
    };
    const act = acts[event.key];
    if (!act) return;
    act();
    event.preventDefault();
  }
}
