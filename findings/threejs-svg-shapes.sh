#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: SVGLoader, by which outlines are extruded, puts half of a turned ellipse elsewhere when it is mirrored, as every drawing with y up
# is; reads "10-5 ", which needs no comma, as one number of a polygon's points; draws corners rounder than half of a plate far outside of it;
# puts an inner svg at the origin in its own units; and makes shapes of clip paths, markers and symbols. Nothing is said. Mirrored circles and
# turned ellipses alone, and copies (use), are right. Believed: as SVG 1.1 has them (5.1.2, 8.3.8, 9.2, 9.7.1, 11.6, 14.3.5).
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0 jsdom@29.1.1
cat >shapes.mjs <<'JS'
import { JSDOM } from 'jsdom';
import { SVGLoader } from 'three/addons/loaders/SVGLoader.js';
globalThis.DOMParser = new JSDOM('').window.DOMParser;
const cases = {
  'half of a circle, mirrored': ['<path transform="scale(1 -1)" d="M20 0A20 20 0 0 1 -20 0"/>', '-20 -20 20 0'],
  'half of a turned ellipse': ['<path d="M20 0A20 10 30 0 1 -20 0"/>', '-20 0 24 17'],
  'the same, mirrored': ['<path transform="scale(1 -1)" d="M20 0A20 10 30 0 1 -20 0"/>', '-20 -17 24 0'],
  'polygon': ['<polygon points="0 0 10-5 3 4"/>', '0 -5 10 4'],
  'plate of 20 x 10, corners of 30': ['<rect width="20" height="10" rx="30"/>', '0 0 20 10'],
  'inner svg': ['<svg x="20" y="30" width="10" height="10" viewBox="0 0 100 100"><path d="M0 0H50V50"/></svg>', '20 30 25 35'],
  'copy': ['<defs><path id="a" d="M0 0H10V5"/></defs><use href="#a" x="5" y="7"/>', '5 7 15 12'],
  'clip path': ['<clipPath id="c"><path d="M0 0H10V5"/></clipPath>', 'nothing'],
  'marker': ['<marker id="m"><path d="M0 0H10V5"/></marker>', 'nothing'],
  'symbol': ['<symbol id="s"><path d="M0 0H10V5"/></symbol>', 'nothing'],
};
for (const [name, [content, right]] of Object.entries(cases)) {
  const { paths } = new SVGLoader().parse(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 100">${content}</svg>`);
  const points = paths.flatMap((path) => path.subPaths.flatMap((part) => part.getPoints(400)));
  const x = points.map((point) => point.x), y = points.map((point) => point.y);
  const box = [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)].map((value) => Math.round(value) + 0).join(' ');
  console.log(`${name}: ${points.length ? box : 'nothing'}, right ${right}`);
}
JS
node shapes.mjs >seen
expect_in seen <<'END'
half of a circle, mirrored: -20 -20 20 0, right -20 -20 20 0
half of a turned ellipse: -20 0 24 17, right -20 0 24 17
the same, mirrored: -10 -17 24 17, right -20 -17 24 0
polygon: -5 0 0 3, right 0 -5 10 4
plate of 20 x 10, corners of 30: -10 -20 30 30, right 0 0 20 10
inner svg: 0 0 50 50, right 20 30 25 35
copy: 5 7 15 12, right 5 7 15 12
clip path: 0 0 10 5, right nothing
marker: 0 0 10 5, right nothing
symbol: 0 0 10 5, right nothing
END
