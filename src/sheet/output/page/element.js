// SPDX-License-Identifier: Apache-2.0
// <epura-drawing src="part.svg">: a drawing in a page that can be moved, scaled and asked about its lines. Without src, the
// SVG element inside it is shown. `epura-line` tells the page which line was chosen.

const shape = `
:host { display: block; position: relative; min-height: 3rem; background: #fff; color: #1d2126; font: 14px/1.4 system-ui, sans-serif; }
:host([hidden]) { display: none; }
.stage { position: absolute; inset: 0; overflow: hidden; cursor: grab; touch-action: pan-x pan-y; }
.stage:focus-visible, button:focus-visible { outline: 3px solid #0057c2; outline-offset: -3px; }
svg { position: absolute; inset: 0; width: 100%; height: 100%; }
.tools { position: absolute; right: .4rem; top: .4rem; display: flex; gap: .2rem; }
button { font: inherit; min-width: 2rem; min-height: 2rem; color: inherit; background: #fff; border: 1px solid #6b747e; border-radius: .3rem; }
output { position: absolute; left: .4rem; bottom: .4rem; padding: .1rem .4rem; background: #fff; border-radius: .3rem; }
output:empty { display: none; }
.mark { fill: none; stroke: #0057c2; stroke-width: 3px; vector-effect: non-scaling-stroke; }
`;

const namespace = 'http://www.w3.org/2000/svg';
const elements = new Set('svg g path text tspan title desc rect circle ellipse line polyline polygon'.split(' '));

// A copy with what draws and nothing else: no scripts, no handlers, no style sheets, no references.
function harmless(node) {
  if (!elements.has(node.localName) || node.namespaceURI !== namespace) return null;
  const copy = document.createElementNS(namespace, node.localName);
  for (const {name, value} of node.attributes) {
    const plain = name.replace('inkscape:label', 'data-label');
    if (/^(on|style$|id$|xmlns)|:|href/i.test(plain) || /url\(/i.test(value)) continue;
    copy.setAttribute(plain, value);
  }
  for (const child of node.childNodes) {
    const part = child.nodeType === Node.TEXT_NODE ? document.createTextNode(child.data)
      : child.nodeType === Node.ELEMENT_NODE ? harmless(child) : null;
    if (part) copy.append(part);
  }
  return copy;
}

const nameOf = group => group?.dataset.view ?? group?.dataset.layer ?? group?.dataset.label ?? '';

class EpuraDrawing extends HTMLElement {
  static get observedAttributes() { return ['src']; }

  connectedCallback() { this.load(); }
  attributeChangedCallback() { if (this.isConnected) this.load(); }

  async load() {
    const turn = this.turn = (this.turn ?? 0) + 1;
    try {
      const svg = this.hasAttribute('src') ? await this.fetched() : this.querySelector('svg');
      if (turn === this.turn && svg) this.show(harmless(svg));
    } catch (error) {
      if (turn === this.turn) this.fail(error);
    }
  }

  async fetched() {
    const answer = await fetch(this.getAttribute('src'));
    if (!answer.ok) throw new Error(`${this.getAttribute('src')}: ${answer.status} ${answer.statusText}`);
    const root = new DOMParser().parseFromString(await answer.text(), 'image/svg+xml').documentElement;
    if (root.localName !== 'svg' || root.querySelector('parsererror')) throw new Error(`${this.getAttribute('src')} is not SVG`);
    return root;
  }

  fail(error) {
    this.root.replaceChildren(Object.assign(document.createElement('p'), {textContent: error.message}));
    this.dispatchEvent(new CustomEvent('epura-error', {detail: error.message}));
  }

  get root() {
    if (!this.shadowRoot) {
      const sheet = new CSSStyleSheet();
      sheet.replaceSync(shape);
      this.attachShadow({mode: 'open'}).adoptedStyleSheets = [sheet];
    }
    return this.shadowRoot;
  }

  show(svg) {
    const [, , width, height] = (svg.getAttribute('viewBox') ?? '0 0 100 100').split(/[\s,]+/).map(Number);
    for (const name of ['width', 'height', 'role', 'aria-labelledby', 'aria-describedby']) svg.removeAttribute(name);
    const title = svg.querySelector(':scope > title')?.textContent || 'Drawing';
    for (const text of svg.querySelectorAll(':scope > title, :scope > desc')) text.remove();
    for (const text of svg.querySelectorAll('[aria-label]:not([role])')) text.setAttribute('role', 'img');
    this.style.aspectRatio = `${width} / ${height}`;
    this.mark = document.createElementNS(namespace, 'path');
    this.mark.setAttribute('class', 'mark');
    svg.append(this.mark);
    const made = (name, properties) => Object.assign(document.createElement(name), properties);
    const stage = made('div', {className: 'stage', tabIndex: 0});
    stage.setAttribute('role', 'group');
    stage.setAttribute('aria-label', `${title}: arrow keys move it, plus and minus zoom, n and p go through its lines`);
    stage.append(svg);
    this.told = made('output', {});
    const tools = made('div', {className: 'tools'});
    const button = (text, label, act) => {
      const one = made('button', {type: 'button', textContent: text, onclick: act});
      one.setAttribute('aria-label', label);
      tools.append(one);
    };
    this.root.replaceChildren(stage, tools, this.told);
    this.nodes = [...svg.querySelectorAll('path[data-kind]')];
    this.grid = this.picked = null;
    this.stage = new Stage(stage, width, height, {
      seen: () => {
        const {x, y, scale, size} = this.stage;
        svg.setAttribute('viewBox', `${x} ${y} ${size.width / scale} ${size.height / scale}`);
      },
      hover: at => this.tell(at ? this.nearest(at) : null),
      pick: at => this.choose(this.nearest(at)),
    });
    this.stage.wheelNeedsKey = true;  // pages scroll
    button('−', 'Zoom out', () => this.stage.zoom(0.8));
    button('+', 'Zoom in', () => this.stage.zoom(1.25));
    button('⤢', 'Show the whole drawing', () => this.stage.fit());
    stage.addEventListener('keydown', event => this.keyDown(event));
    this.dispatchEvent(new CustomEvent('epura-ready', {detail: {lines: this.nodes.length}}));
  }

  keyDown(event) {
    const by = {n: 1, p: -1}[event.key];
    if (!by || event.ctrlKey || event.metaKey || event.altKey || this.nodes.length === 0) return;
    const count = this.nodes.length;
    this.choose(((this.picked ?? (by > 0 ? -1 : 0)) + by + count) % count);
    event.preventDefault();
  }

  nearest({x, y}) {
    if (!this.grid) {
      const segments = [], lines = [];
      this.nodes.forEach((node, number) => {
        const {points, closed} = parsePath(node.getAttribute('d'));
        if (closed) points.push(points[0], points[1]);
        for (let i = 0; i + 3 < points.length; i += 2) {
          segments.push(...points.slice(i, i + 4));
          lines.push(number);
        }
      });
      this.grid = new LineGrid(Float32Array.from(segments), Uint32Array.from(lines), this.stage.width, this.stage.height);
    }
    return this.grid.near(x, y, Math.max(0.3, 10 / this.stage.scale), () => true)[0] ?? null;
  }

  about(number) {
    const node = this.nodes[number], layer = node.parentNode.closest('g'), view = layer?.parentNode.closest('g');
    return {view: nameOf(view), layer: nameOf(layer), kind: node.dataset.kind, model: Number(node.dataset.model ?? layer?.dataset.model ?? NaN),
            edges: (node.dataset.edge ?? '').split(' ').filter(Boolean)};
  }

  tell(number) {
    const shown = number ?? this.picked;
    this.mark.setAttribute('d', shown === null ? '' : this.nodes[shown].getAttribute('d'));
    if (shown === null) return this.told.replaceChildren();
    const {view, layer, kind, edges} = this.about(shown);
    return this.told.replaceChildren([`${kind}, ${layer}`, view, edges.length > 3 ? `${edges.length} edges` : edges.join(', ')]
      .filter(Boolean).join(' · '));
  }

  choose(number) {
    this.picked = number;
    this.tell(null);
    this.dispatchEvent(new CustomEvent('epura-line', {detail: number === null ? null : this.about(number)}));
  }
}

customElements.define('epura-drawing', EpuraDrawing);
