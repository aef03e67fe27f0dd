#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: GCodeLoader draws a square of 10 mm only as slicers write it. Leading zeros (G01), line numbers, words without
# blanks: no line at all; coordinates alone, which go on with the last G1: not drawn; inches (G20): 10 of 254 mm; a coordinate in a
# comment in parentheses is driven to. Nothing is said. Believed: a loader "for 3D printing or CNC", as its page says, reads these.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >square.mjs <<'JS'
import { GCodeLoader } from 'three/examples/jsm/loaders/GCodeLoader.js';
const square = ['G1 X10 Y0 F100', 'G1 X10 Y10', 'G1 X0 Y10', 'G1 X0 Y0'];
const programs = {
  plain: square,
  'leading zeros': square.map(line => line.replace('G1', 'G01')),
  'line numbers': square.map((line, i) => `N${10 * i} ${line}`),
  'no blanks': square.map(line => line.replaceAll(' ', '')),
  modal: square.map((line, i) => (i ? line.replace('G1 ', '') : line)),
  inches: ['G20', ...square],
  comment: square.map(line => line + ' (not to X99)'),
};
console.warn = console.error = text => console.log('message:', text);
for (const [name, lines] of Object.entries(programs)) {
  let length = 0, right = 0;
  new GCodeLoader().parse(lines.join('\n') + '\n').traverse(({ geometry }) => {
    if (!geometry) return;
    const p = geometry.attributes.position;
    for (let i = 0; i < p.count; i += 2) {
      length += Math.hypot(p.getX(i + 1) - p.getX(i), p.getY(i + 1) - p.getY(i));
      right = Math.max(right, p.getX(i), p.getX(i + 1));
    }
  });
  console.log(`${name}: ${length} long, up to x = ${right}`);
}
JS
node square.mjs >seen
expect_in seen <<'END'
plain: 40 long, up to x = 10
leading zeros: 0 long, up to x = 0
line numbers: 0 long, up to x = 0
no blanks: 0 long, up to x = 0
modal: 10 long, up to x = 10
inches: 40 long, up to x = 10
comment: 119 long, up to x = 99
END
