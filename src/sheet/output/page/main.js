// SPDX-License-Identifier: Apache-2.0
// The page: sheets, panels and the parts above put together.

const byId = id => document.getElementById(id);

// An element with text: texts of the drawing are never parsed as markup.
function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const inSvg = name => document.createElementNS('http://www.w3.org/2000/svg', name);

class SheetPage {
  constructor(section, data, tell) {
    Object.assign(this, {section, data, tell});
    this.svg = section.querySelector('svg');
    this.marks = this.svg.parentNode.appendChild(inSvg('svg'));
    this.marks.setAttribute('class', 'marks');
    this.marks.setAttribute('aria-hidden', 'true');
    this.stage = new Stage(section, data.width, data.height, {
      seen: () => this.seen(), hover: at => this.hover(at), pick: (at, pointer) => this.pick(at, pointer),
    });
    this.measuring = false;
    this.from = this.picked = null;
    section.addEventListener('keydown', event => this.keyDown(event));
  }

  get lines() {
    if (!this.known) {
      const packed = this.section.querySelector('script');
      this.known = packed ? new PackedLines(this.svg, this.data, JSON.parse(packed.textContent)) : new SvgLines(this.svg, this.data);
      packed?.remove();
      this.painter = packed && new Painter(this.section, this.known);
    }
    return this.known;
  }

  // After other layers or colours.
  renew() {
    this.painter?.renew();
    this.seen();
  }

  seen() {
    if (this.lines && this.painter) {
      this.painter.dark = document.documentElement.classList.contains('dark');
      if (this.painter.paint(this.stage)) this.stage.changed();
    }
    const {x, y, scale, size: {width, height}} = this.stage, base = this.base;
    // The pictures are twice as wide and high as the stage: small steps only move them, which browsers do fast.
    let dx = 0, dy = 0;
    if (base && base.scale === scale && base.width === width && base.height === height) {
      dx = (base.x - x) * scale;
      dy = (base.y - y) * scale;
    }
    if (!base || base.scale !== scale || base.width !== width || base.height !== height || Math.abs(dx) > width / 2 ||
        Math.abs(dy) > height / 2) {
      dx = dy = 0;
      this.base = {x, y, scale, width, height};
      const box = [x - width / scale / 2, y - height / scale / 2, 2 * width / scale, 2 * height / scale].join(' ');
      for (const svg of [this.svg, this.marks]) svg.setAttribute('viewBox', box);
    }
    for (const svg of [this.svg, this.marks]) svg.style.transform = `translate(${dx}px, ${dy}px)`;
    for (const ring of this.marks.querySelectorAll('circle')) ring.setAttribute('r', 5 / scale);
  }

  // Before the sheet is printed, all of it is shown.
  whole() {
    this.svg.setAttribute('viewBox', `0 0 ${this.data.width} ${this.data.height}`);
    this.base = null;
    if (this.lines) this.painter?.print();
  }

  mark(name, d) {
    this.unmark(name);
    if (!d) return;
    const path = inSvg('path');
    path.setAttribute('class', name);
    path.setAttribute('d', d);
    this.marks.append(path);
  }

  ring(name, at) {
    this.unmark(name);
    if (!at) return;
    const ring = inSvg('circle');
    ring.setAttribute('class', name);
    ring.setAttribute('cx', at.x);
    ring.setAttribute('cy', at.y);
    ring.setAttribute('r', 5 / this.stage.scale);
    this.marks.append(ring);
  }

  unmark(name) { for (const old of this.marks.querySelectorAll('.' + name)) old.remove(); }

  // In mm: near enough to mean a line, whose ink may be wide.
  reach(pointer) { return Math.max(0.3, (pointer === 'touch' ? 20 : 8) / this.stage.scale); }

  hover(at) {
    if (at && this.measuring) return this.ring('snap', this.lines.nearestMark(at.x, at.y, this.reach('touch')));
    const [line] = at ? this.lines.near(at.x, at.y, this.reach()) : [];
    this.mark('hovered', line === undefined ? '' : this.lines.pathOf(line));
    if (line !== undefined) this.tell.line(this.lines.facts(line));
    else this.tell.line(this.picked === null ? null : this.lines.facts(this.picked));
    return undefined;
  }

  pick(at, pointer) {
    if (this.measuring) return this.pickMark(this.lines.nearestMark(at.x, at.y, this.reach('touch')));
    const near = this.lines.near(at.x, at.y, this.reach(pointer));
    // Another click on the same lines goes to the next one of them.
    const next = near[(near.indexOf(this.picked) + 1) % near.length];
    return this.choose(next ?? null);
  }

  choose(line, aloud = false) {
    this.picked = line;
    this.mark('picked', line === null ? '' : this.lines.pathOf(line));
    this.tell.line(line === null ? null : this.lines.facts(line), aloud);
  }

  pickMark(mark) {
    if (!mark) return;
    if (!this.from) {
      this.unmark('measured');
      this.ring('from', mark);
      this.from = mark;
      this.tell.measured({text: `from ${mark.name}; choose the other end`, parts: []});
      return;
    }
    const found = this.lines.measure(this.from, mark);
    this.ring('to', mark);
    this.mark('measured', `M${this.from.x} ${this.from.y}L${mark.x} ${mark.y}`);
    this.from = null;
    this.tell.measured(found);
  }

  measure(on) {
    this.measuring = on;
    this.from = null;
    for (const name of ['snap', 'from', 'to', 'measured', 'hovered']) this.unmark(name);
    this.section.classList.toggle('measuring', on);
  }

  // Steps through the lines, or through ends and centres while measuring.
  step(by) {
    const shownFrom = (start, count, isShown) => {
      for (let i = 1; i <= count; ++i) {
        const next = ((start + by * i) % count + count) % count;
        if (isShown(next)) return next;
      }
      return null;
    };
    if (this.measuring && this.picked !== null) {
      const marks = this.lines.marks(this.picked);
      const old = marks.findIndex(mark => this.keyed && mark.x === this.keyed.x && mark.y === this.keyed.y);
      const next = old + by;
      if (next >= 0 && next < marks.length) {
        this.keyed = marks[next];
        this.ring('snap', this.keyed);
        this.tell.measured({text: `${this.keyed.name}; Enter takes it`, parts: []});
        return;
      }
    }
    const start = this.picked ?? (by > 0 ? -1 : 0);
    const next = shownFrom(start, this.lines.count, number => this.lines.isShown(number));
    if (next === null) return;
    this.choose(next, true);
    this.keyed = null;
    const {points} = this.lines.line(next), box = {x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity};
    for (let i = 0; i < points.length; i += 2) {
      box.x0 = Math.min(box.x0, points[i]);
      box.x1 = Math.max(box.x1, points[i]);
      box.y0 = Math.min(box.y0, points[i + 1]);
      box.y1 = Math.max(box.y1, points[i + 1]);
    }
    this.stage.show(box);
  }

  keyDown(event) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const acts = {
      n: () => this.step(1), p: () => this.step(-1), m: () => this.tell.command('measure'),
      Enter: () => this.keyed && this.measuring && this.pickMark(this.keyed),
      Escape: () => (this.measuring ? this.tell.command('measure') : this.choose(null)),
    };
    const act = acts[event.key];
    if (!act) return;
    act();
    event.preventDefault();
  }
}

// What is known of a line, as a list of terms.
function factList(facts) {
  const rows = [['Line', `${facts.kind}, ${facts.visible ? 'visible' : 'hidden'}`], ['View', facts.view]];
  if (facts.modelName) rows.push(['Model', `${facts.model}: ${facts.modelName}`]);
  if (facts.body) rows.push(['Body', facts.body]);
  const edges = facts.edges.length;
  if (edges === 1) rows.push(['Edge', facts.edges[0]]);
  if (edges > 1) rows.push(['Edges', `${facts.edges.slice(0, 4).join(', ')}${edges > 4 ? `, … (${edges})` : ''}`]);
  if (facts.faces.length > 0)
    rows.push(['Faces', facts.faces.join(', ') + (facts.moreFaces ? `, … (${facts.faces.length + facts.moreFaces})` : '')]);
  if (facts.length !== null) rows.push([edges > 1 ? 'True length of all' : 'True length', shown(facts.length)]);
  return element('dl', {}, ...rows.flatMap(([term, text]) => [element('dt', {}, term), element('dd', {}, text)]));
}

// Check boxes for the layers of the views and for the kinds of edges of a sheet.
function layerList(page) {
  const list = element('ul');
  const box = (text, isOn, change) => {
    const input = element('input', {type: 'checkbox'});
    input.checked = isOn;
    input.addEventListener('change', () => change(input.checked));
    return element('li', {}, element('label', {}, input, ' ', text));
  };
  const boxOf = (group, name) => box(name, !group.hasAttribute('hidden'), on => {
    group.toggleAttribute('hidden', !on);
    page.renew();
  });
  for (const group of page.svg.querySelectorAll('g[data-view], svg > g[data-layer]')) {
    const item = boxOf(group, group.dataset.view ?? group.dataset.layer);
    const layers = group.dataset.view === undefined ? [] : [...group.querySelectorAll('g[data-layer]')];
    if (layers.length > 0) item.append(element('ul', {}, ...layers.map(layer => boxOf(layer, layer.dataset.layer))));
    list.append(item);
  }
  const kinds = [...page.lines.kinds].map(([kind, count]) => box(`${kind} (${count})`, page.lines.isKindShown(kind), on => {
    page.lines.showKind(kind, on);
    page.renew();
  }));
  return [list, element('ul', {'aria-label': 'Kinds of lines'}, ...kinds)];
}

// The lines and texts of a sheet that contain all words: by body, model, kind, layer, view and edge.
const mostFound = 5000;  // marked
function search(page, text) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  page.unmark('found');
  if (words.length === 0) return null;
  const fits = where => words.every(word => where.toLowerCase().includes(word));
  let d = '', count = 0, first = null;
  for (let number = 0; number < page.lines.count; ++number) {
    const facts = page.lines.facts(number);
    if (!fits([facts.body, facts.modelName, facts.kind, facts.layer, facts.view, ...facts.edges].join(' '))) continue;
    if (!page.lines.isShown(number)) continue;
    first ??= number;
    if (++count <= mostFound) d += page.lines.pathOf(number);
  }
  page.mark('found', d);
  const texts = [...page.svg.querySelectorAll('[aria-label], text')];
  const found = texts.filter(node => fits(node.getAttribute('aria-label') ?? node.textContent)).length;
  return {count, first, texts: found};
}

function start() {
  const data = JSON.parse(byId('data').textContent);
  const say = (where, ...children) => byId(where).replaceChildren(...children);
  const tell = {
    line: (facts, aloud) => {
      byId('facts').setAttribute('aria-live', aloud ? 'polite' : 'off');
      say('facts', facts ? factList(facts) : 'Point at a line or press n in the drawing.');
    },
    measured: ({text, parts}) => say('measured', text, ...parts.map(part => element('span', {}, part))),
    command: name => commands[name](),
  };
  const pages = [...document.querySelectorAll('.sheet')].map((section, i) => new SheetPage(section, data.sheets[i], tell));
  let page = pages[0];
  const press = (name, on) => document.querySelector(`[data-do=${name}]`).setAttribute('aria-pressed', String(on));
  const commands = {
    fit: () => page.stage.fit(), in: () => page.stage.zoom(1.25), out: () => page.stage.zoom(0.8),
    measure: () => {
      page.measure(!page.measuring);
      press('measure', page.measuring);
      tell.measured({text: page.measuring ? 'Choose two ends or corners or centres.' : '', parts: []});
    },
    dark: () => {
      const on = document.documentElement.classList.toggle('dark');
      document.documentElement.classList.toggle('light', !on);
      press('dark', on);
      page.renew();
    },
    print: () => window.print(),
  };
  for (const button of document.querySelectorAll('[data-do]'))
    button.addEventListener('click', () => commands[button.dataset.do]());

  const open = number => {
    if (page.measuring) commands.measure();
    page = pages[number];
    pages.forEach((other, i) => {
      other.section.hidden = i !== number;
      other.stage.active = i === number;
    });
    page.stage.resized();
    page.renew();
    say('layers', ...layerList(page));
    tell.line(null);
  };
  const choice = byId('sheets');
  choice.closest('label').hidden = pages.length < 2;
  data.sheets.forEach((sheet, i) => choice.append(element('option', {value: i}, sheet.title || `Sheet ${i + 1}`)));
  choice.addEventListener('change', () => open(Number(choice.value)));

  const field = byId('search');
  const find = () => {
    const found = search(page, field.value);
    const count = (number, what) => `${number} ${what}${number === 1 ? '' : 's'}`;
    byId('found').textContent = found ? `${count(found.count, 'line')}, ${count(found.texts, 'text')}` : '';
    return found;
  };
  field.addEventListener('input', find);
  byId('searching').addEventListener('submit', event => {
    event.preventDefault();
    const found = find();
    if (found && found.first !== null) page.choose(found.first, true);
  });

  const dark = matchMedia('(prefers-color-scheme: dark)').matches;
  document.documentElement.classList.add(dark ? 'dark' : 'light');
  press('dark', dark);
  // One page of paper for each sheet, as large as the sheet.
  const paper = new CSSStyleSheet();
  paper.replaceSync(pages.map(({data: {width, height}}, i) =>
    `@page sheet${i} {size: ${width}mm ${height}mm; margin: 0}`).join('\n'));
  document.adoptedStyleSheets = [paper];
  pages.forEach(({section, svg, data: {width, height}}, i) => {
    section.style.setProperty('--width', `${width}mm`);
    section.style.setProperty('--height', `${height}mm`);
    section.style.setProperty('page', `sheet${i}`);
  });
  window.addEventListener('beforeprint', () => pages.forEach(one => one.whole()));
  window.addEventListener('afterprint', () => pages.forEach(one => one.renew()));
  if (data.answers) {
    byId('answers').textContent = data.answers;
    byId('why').hidden = false;
  }
  document.body.classList.add('ready');
  open(0);
}

start();
