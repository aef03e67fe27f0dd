// SPDX-License-Identifier: Apache-2.0
// Moves the wireframe with the sliders, and asks the server for views and for exact drawings.

const data = JSON.parse(document.getElementById('data').textContent);
const {box, projections, start} = data.model;
const part = id => document.getElementById(id);
const me = crypto.getRandomValues(new Uint32Array(2)).join('-');
const restMs = 300, quickMs = 2000;
const page = {name: start.name, values: new Map(start.values), view: data.model.view, model: null, took: 0, svg: null};

const entry = () => projections.find(projection => projection.name === page.name);
const request = () => requestOf(page.name, page.values);

const say = (text, isWrong = false) => {
  part('status').textContent = text;
  part('status').classList.toggle('wrong', isWrong);
};

// As app/run_epura.cpp has it.
const forShell = word => /^[a-zA-Z0-9_.\/=:,+@%-]+$/.test(word) ? word : "'" + word.replaceAll("'", "'\\''") + "'";

const steps = () => stepsOf(page.view);

const showMatrices = () => {
  const number = value => String(Number(value.toPrecision(6)));
  const table = ([symbol, matrix]) => element('table', {}, element('caption', {}, symbol), ...[0, 1, 2, 3].map(row =>
    element('tr', {}, ...matrix.slice(4 * row, 4 * row + 4).map(value => element('td', {}, number(value))))));
  part('matrices').replaceChildren(...[...steps(), ['World to page (mm)', productOf(steps())]].map(table));
};

// The sheet as large as there is room for it, on whole pixels of the screen.
const fit = () => {
  const room = part('paper').parentElement, style = getComputedStyle(room), [width, height] = page.view.paper;
  const free = [room.clientWidth - 2 * parseFloat(style.paddingLeft), room.clientHeight - 2 * parseFloat(style.paddingTop)];
  const scale = Math.max(0.1, Math.min(free[0] / width, free[1] / height));
  Object.assign(part('paper').style, {width: width * scale + 'px', height: height * scale + 'px'});
  part('wires').width = Math.round(width * scale * devicePixelRatio);
  part('wires').height = Math.round(height * scale * devicePixelRatio);
};

const show = () => {
  if (!page.model) return;
  paint(part('wires'), page.model, mapped(page.model, steps()), page.view);
  part('paper').setAttribute('aria-label', (part('drawing').hidden ? 'Wireframe of ' : 'Exact drawing of ') + data.title + ', ' + page.name);
  if (part('matrices').parentElement.open) showMatrices();
};

const hideExact = () => {
  part('drawing').hidden = true;
  part('wires').hidden = false;
  part('save').hidden = true;
};

const fetchFrom = async (resource, options = {}) => {
  const answer = await fetch(resource + '?page=' + me + '&projection=' + encodeURIComponent(request()), options);
  if (answer.ok) return answer;
  const {error, hint} = await answer.json();
  throw Object.assign(new Error(error + (hint ? '\n' + hint : '')), {isOld: answer.status === 409});
};

const report = error => {
  if (error.isOld || error.name === 'AbortError') return;
  say(error instanceof TypeError ? 'The server does not answer: has it been ended?' : error.message, true);
};

// One request at a time; when it is answered, the newest values are asked for.
let asking = null, isChanged = false;
const askUntilNew = async () => {
  let isRefused = false;
  while (isChanged) {
    isChanged = false;
    try {
      const view = await (await fetchFrom('view')).json(), isOther = view.paper.join() !== page.view.paper.join();
      page.view = view;
      if (isOther) fit();
      // What is wrong with the exact drawing stays.
      if (isRefused) say('Wireframe');
      isRefused = false;
      requestAnimationFrame(show);
    } catch (error) {
      isRefused = true;
      report(error);
    }
  }
  asking = null;
};
const askForView = () => {
  isChanged = true;
  return asking ??= askUntilNew();
};

let drawing = new AbortController();
const drawExactly = async () => {
  clearTimeout(resting);
  drawing.abort();
  drawing = new AbortController();
  const begun = performance.now();
  say('Drawing exactly\u2026');
  try {
    const answer = await fetchFrom('drawing', {signal: drawing.signal}), svg = await answer.blob();
    const messages = decodeURIComponent(answer.headers.get('Epura-Messages') ?? '');
    page.took = performance.now() - begun;
    page.svg = svg;
    URL.revokeObjectURL(part('drawing').src);
    part('drawing').src = part('save').href = URL.createObjectURL(svg);
    part('save').download = data.title.replace(/\.[^.]*$/, '') + '.svg';
    await part('drawing').decode();
    part('drawing').hidden = part('save').hidden = false;
    part('wires').hidden = true;
    show();
    say('Exact drawing, ' + (page.took / 1000).toFixed(2) + '\u00a0s' + (messages ? '\n' + messages : ''));
  } catch (error) {
    report(error);
  }
};

let resting = 0;
const changed = () => {
  clearTimeout(resting);
  drawing.abort();
  hideExact();
  say('Wireframe');
  // Lines end between words only, not at hyphens.
  const words = (data.before + forShell(request()) + data.after).split(' ').map(word => element('span', {}, word));
  part('command').replaceChildren(...words.flatMap(word => [word, ' ']).slice(0, -1));
  // Drawings that take long are made on request only.
  if (part('resting').checked && page.took < quickMs) resting = setTimeout(drawExactly, restMs);
  return askForView();
};

const showFields = () => {
  const {parameters, summary, reference} = entry();
  part('projection').value = page.name;
  part('summary').textContent = summary + (reference ? ' (' + reference + ')' : '');
  part('parameters').replaceChildren(...parameters.map(parameter => fieldOf(parameter, page.values, page.view, box, changed)));
};

const choose = async (name, values = []) => {
  page.name = name;
  page.values = new Map(values);
  await changed();
  showFields();
};

const listProjections = () => {
  for (const family of new Set(projections.map(projection => projection.family)))
    part('projection').append(element('optgroup', {label: family}, ...projections.filter(projection => projection.family === family).map(
      ({name, summary}) => element('option', {value: name, title: summary}, name))));
};

const setDark = on => {
  document.documentElement.classList.toggle('dark', on);
  part('dark').setAttribute('aria-pressed', on);
};

part('projection').addEventListener('change', () => choose(part('projection').value));
part('exact').addEventListener('click', drawExactly);
part('reset').addEventListener('click', () => choose(page.name));
part('dark').addEventListener('click', () => setDark(!document.documentElement.classList.contains('dark')));
part('copy').addEventListener('click', () => navigator.clipboard.writeText(part('command').textContent).then(() => say('Copied.'), report));
part('matrices').parentElement.addEventListener('toggle', showMatrices);
part('parameters').addEventListener('submit', event => {
  event.preventDefault();
  drawExactly();
});
addEventListener('resize', () => {
  fit();
  show();
});

// For those who want to calculate on: what the page knows, in the browser's console.
window.epura = {
  // 'two-point:azimuth=70', as on the command line.
  show(text) {
    const [name, ...values] = text.split(':');
    return choose(name, values.map(value => [value.slice(0, value.indexOf('=')), value.slice(value.indexOf('=') + 1)]));
  },
  get view() { return page.view; },
  get matrices() { return Object.fromEntries([...steps(), ['product', productOf(steps())]]); },
  // The exact drawing as SVG, a promise.
  get drawing() { return page.svg?.text(); },
  // Each vertex of the model on the page, mm.
  get points() {
    const {page: at} = mapped(page.model, steps()), points = [];
    for (let i = 0; i < at.length; i += 3) points.push([at[i] / at[i + 2], at[i + 1] / at[i + 2]]);
    return points;
  },
};

setDark(matchMedia('(prefers-color-scheme: dark)').matches);
listProjections();
fit();
fetch('model').then(answer => answer.arrayBuffer()).then(buffer => {
  page.model = wireframeOf(buffer);
  showFields();
  show();
  return changed();
}).catch(report);
