// SPDX-License-Identifier: Apache-2.0
// The parameters of a projection as sliders, numbers and lists, from the table of its plugin.

const element = (name, properties = {}, ...children) => {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties))
    if (key in made) made[key] = value;
    else made.setAttribute(key, value);
  made.append(...children);
  return made;
};

// As many digits as a step of a slider tells apart.
const tidy = (value, step) => Number(value.toFixed(Math.min(12, Math.max(0, 1 - Math.floor(Math.log10(step))))));

const sizeOf = box => Math.hypot(...box[1].map((x, i) => x - box[0][i])) || 1;

// The part of a parameter's range that a slider covers: the table's, unless it is so wide that no hand could choose.
const sliderRange = (parameter, start, box) => {
  const min = parameter.min ?? -Infinity, max = parameter.max ?? Infinity;
  const isPlace = parameter.unit === 'model units', reach = isPlace ? 2 * sizeOf(box) : parameter.unit === 'deg' ? 360 : 2;
  if (max - min <= 10 * reach) return [min, max];
  if (isPlace) return [Math.max(min, start - reach), Math.min(max, start + reach)];
  return [Math.max(min, Math.min(-reach, 2 * start)), Math.min(max, Math.max(reach, 4 * start))];
};

// 1, 2 or 5 times a power of ten: about 500 steps.
const stepOf = range => {
  const raw = (range || 1) / 500, power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find(factor => factor * power >= raw * 0.999);
};

const startOfNumber = (parameter, view, box) => {
  if (/distance/.test(parameter.help) && view.central) return Math.abs(view.PRP[2] - view.VPD);
  return (parameter.min ?? -1) >= 0 ? sizeOf(box) : 0;
};

// Where a slider begins whose default the projection derives from the model: at the number of the view that the document
// calls by the parameter's name; at the eye, for parameters that speak of it; otherwise at the model's centre.
const startOf = (parameter, view, box) => {
  const known = view[parameter.name.toUpperCase()] ?? view[parameter.name];
  if (parameter.type === 'number') return typeof known === 'number' ? known : startOfNumber(parameter, view, box);
  const centre = box[0].map((x, i) => (x + box[1][i]) / 2);
  const size = parameter.initial.length;
  if (Array.isArray(known) && known.length === size) return known;
  if (view.central && size === 3 && /\beye\b|centre of projection/.test(parameter.help))
    return [0, 1, 2].map(i => view.VRP[i] + view.PRP[0] * view.u[i] + view.PRP[1] * view.v[i] + view.PRP[2] * view.n[i]);
  return size === 3 ? centre : parameter.initial.map(() => 0);
};

// A slider and a number for one value; `changed(value)` is called when the user moves one of them.
const slider = (id, label, described, parameter, value, box, changed) => {
  let [min, max] = sliderRange(parameter, value, box);
  const step = stepOf(max - min);
  const range = element('input', {type: 'range', id: id + '-range', min, max, step, 'aria-describedby': described});
  const number = element('input', {type: 'number', id, step: 'any', 'aria-label': label, 'aria-describedby': described});
  range.setAttribute('aria-label', label);
  const say = () => range.setAttribute('aria-valuetext', number.value + (parameter.unit.length > 1 ? '\u00a0' + parameter.unit : ''));
  number.value = tidy(value, step / 100);
  range.value = value;
  say();
  range.addEventListener('input', () => {
    number.value = tidy(Number(range.value), step);
    say();
    changed(Number(number.value));
  });
  number.addEventListener('input', () => {
    const typed = number.value === '' ? NaN : Number(number.value);
    const isWrong = !Number.isFinite(typed) || typed < (parameter.min ?? -Infinity) || typed > (parameter.max ?? Infinity);
    number.setAttribute('aria-invalid', isWrong);
    if (isWrong) return;
    range.min = min = Math.min(min, typed);
    range.max = max = Math.max(max, typed);
    range.value = typed;
    say();
    changed(typed);
  });
  const letter = element('span', {className: 'unit', 'aria-hidden': 'true'}, label.includes(' ') ? label.split(' ')[1] : '');
  return element('div', {className: 'value'}, letter, range, number);
};

const axesOf = ({help, initial}) => initial.length > 3 ? [1, 2, 3, 4, 5, 6, 7, 8] : /\bu,? v,? n\b/.test(help) ? ['u', 'v', 'n'] : ['x', 'y', 'z'];

// `values` has what the user has set: texts as on the command line, by name. `changed()` is called after each change.
const fieldOf = (parameter, values, view, box, changed) => {
  const {name, type, unit, help, choices, initial} = parameter;
  const described = 'help-' + name, isSet = () => values.has(name);
  const reset = element('button', {type: 'button', title: 'Back to the default', 'aria-label': 'Default of ' + name}, '↺');
  const set = text => {
    values.set(name, text);
    reset.disabled = false;
    changed();
  };
  reset.disabled = !isSet();
  const heading = element('legend', {}, name, element('span', {className: 'unit'}, unit === '1' ? '' : unit), reset);
  const inputs = [];
  // Also what is as good as no limit, and windows that say so.
  const isDerived = type !== 'choice' && (initial.some(value => value === null || Math.abs(value) > 1e6 * sizeOf(box)) ||
    (name === 'window' && initial.every(value => value === 0)));
  if (type === 'choice') {
    const select = element('select', {id: 'p-' + name, 'aria-label': name, 'aria-describedby': described});
    choices.forEach(word => select.append(element('option', {value: word}, word)));
    select.value = isSet() ? values.get(name) : choices[initial[0]];
    select.addEventListener('change', () => set(select.value));
    inputs.push(select);
  } else {
    const start = isSet() ? values.get(name).split(',').map(Number) : isDerived ? [startOf(parameter, view, box)].flat() : initial;
    const now = start.map(value => tidy(value, 1e-6));
    now.forEach((value, i) => {
      const label = now.length === 1 ? name : name + ' ' + axesOf(parameter)[i];
      inputs.push(slider('p-' + name + (now.length === 1 ? '' : '-' + i), label, described, parameter, value, box, changedTo => {
        now[i] = changedTo;
        set(now.join());
      }));
    });
  }
  const derived = isDerived && !isSet() ? ' Chosen by the projection until it is moved.' : '';
  const field = element('fieldset', {}, heading, element('p', {className: 'help', id: described}, help + '.' + derived), ...inputs);
  reset.addEventListener('click', () => {
    values.delete(name);
    changed();
    field.replaceWith(fieldOf(parameter, values, view, box, changed));
    document.getElementById(inputs.length ? 'p-' + name + (type === 'vector' ? '-0' : '') : 'projection')?.focus();
  });
  return field;
};

// As on the command line: only what differs from the defaults.
const requestOf = (name, values) => [name, ...[...values].map(([key, text]) => key + '=' + text)].join(':');
