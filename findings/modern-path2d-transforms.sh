#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# modern-path2d 1.6.0 (npm) reads SVG without its turns and skews, without the transforms of groups, with NaN for a matrix whose numbers stand apart by
# blanks, and with what is hidden. Of a path it writes arcs of more than a half circle as the rest of their circle, and gives boxes of turned ellipses
# elsewhere. Nothing is said. translate, scale and matrix with commas, on the path itself, are right. Believed: what browsers draw.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages modern-path2d@1.6.0 jsdom@29.1.1
cat >paths.mjs <<'JS'
import { JSDOM } from 'jsdom';
globalThis.DOMParser = new JSDOM('').window.DOMParser;
const { Path2D, svgToPath2DSet } = await import('modern-path2d');
const tidy = (path) => path.toData().replace(/-?\d+(\.\d+)?(e-?\d+)?/g, (number) => `${+(+number).toFixed(1) + 0}`);
const box = ({ left, top, width, height }) => [left, top, left + width, top + height].map((value) => +value.toFixed(1) + 0).join(' ');
for (const path of ['M10 0A10 10 0 0 1 0 10', 'M10 0A10 10 0 1 1 0 -10', 'M0 0A20 10 30 0 1 20 0', 'M-10 0A10 5 0 0 1 10 0'])
  console.log(`${path}: within ${box(new Path2D(path).getBoundingBox())}, written as ${tidy(new Path2D(path))}`);
const drawn = (shape) => svgToPath2DSet(`<svg xmlns="http://www.w3.org/2000/svg">${shape}</svg>`).paths.map(tidy).join(', ');
for (const transform of ['translate(10,20)', 'scale(2) translate(10,0)', 'rotate(90)', 'skewX(45)', 'matrix(1,0,0,-1,0,100)', 'matrix(1 0 0 -1 0 100)'])
  console.log(`${transform}: ${drawn(`<path transform="${transform}" d="M0 0H10V5"/>`)}`);
console.log(`group translate(10,20): ${drawn('<g transform="translate(10,20)"><path d="M0 0H10V5"/></g>')}`);
console.log(`hidden: ${drawn('<path display="none" d="M0 0H10V5"/>')}`);
JS
node paths.mjs >seen 2>messages || cat messages
expect_in seen <<'END'
M10 0A10 10 0 0 1 0 10: within 0 0 10 10, written as M 10 0 A 10 10 0 0 1 0 10
M10 0A10 10 0 1 1 0 -10: within -10 -10 10 10, written as M 10 0 A 10 10 0 0 1 0 -10
M0 0A20 10 30 0 1 20 0: within -0.7 2.7 10.1 20, written as M 0 0 A 20 10 30 0 1 20 0
M-10 0A10 5 0 0 1 10 0: within -10 -5 10 0, written as M -10 0 A 10 5 0 0 1 10 0
translate(10,20): M 10 20 L 20 20 L 20 25
scale(2) translate(10,0): M 20 0 L 40 0 L 40 10
rotate(90): M 0 0 L 10 0 L 10 5
skewX(45): M 0 0 L 10 0 L 10 5
matrix(1,0,0,-1,0,100): M 0 100 L 10 100 L 10 95
matrix(1 0 0 -1 0 100): M NaN NaN L NaN NaN L NaN NaN
group translate(10,20): M 0 0 L 10 0 L 10 5
hidden: M 0 0 L 10 0 L 10 5
END
