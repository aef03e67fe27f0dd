#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svgdom 0.1.29, on which SVG.js stands outside of browsers, takes every ellipse for a circle when it measures it: <ellipse> of 8 x 4 has a box of 8 x 8,
# and points and boxes of elliptical arcs lie elsewhere, though their lengths are right. The box of a copy (use) ignores its x and y, and
# that of a group has what is not drawn: display none, clip paths, markers and symbols. Circles, curves and transforms are right. Nothing is
# said. Believed: as getBBox and getPointAtLength are in browsers (SVG 1.1, 4.5.2 and 8.3.8), here by svg-path-bbox and by hand.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svgdom@0.1.29 svg-path-bbox@2.1.0 svg-path-properties@2.1.0
cat >boxes.mjs <<'JS'
import { createRequire } from 'module';
import { createSVGWindow } from 'svgdom';
const require = createRequire(import.meta.url);
const { svgPathBbox } = require('svg-path-bbox'), { svgPathProperties } = require('svg-path-properties');
const { document } = createSVGWindow();
const numbers = (values) => values.map((value) => (+value.toFixed(1) + 0).toFixed(1)).join(' ');
const measured = (content) => {
  document.documentElement.innerHTML = content;
  const element = document.documentElement.firstChild, { x, y, width, height } = element.getBBox();
  return [element, numbers([x, y, x + width, y + height])];
};
for (const path of ['M10 0A10 10 0 0 1 -10 0', 'M20 0A20 10 0 0 1 -20 0', 'M20 0A20 10 30 0 1 -20 0']) {
  const [element, box] = measured(`<path d="${path}"/>`), right = new svgPathProperties(path), half = right.getTotalLength() / 2;
  const here = element.getPointAtLength(half), there = right.getPointAtLength(half);
  console.log(`${path}: box ${box}, right ${numbers(svgPathBbox(path))}; half of ${numbers([element.getTotalLength()])} at ${numbers([here.x, here.y])}, right ${numbers([there.x, there.y])}`);
}
const square = '<rect width="10" height="10"/>', other = '<rect x="50" width="10" height="10"/>';
for (const [content, right] of [['<ellipse cx="5" cy="6" rx="4" ry="2"/>', '1 4 9 8'], ['<circle cx="5" cy="6" r="4"/>', '1 2 9 10'],
  [`<g>${square}<rect x="50" width="10" height="10" display="none"/></g>`, '0 0 10 10'], [`<g>${square}<clipPath id="c">${other}</clipPath></g>`, '0 0 10 10'],
  [`<g>${square}<symbol id="s">${other}</symbol></g>`, '0 0 10 10'], [`<g><use href="#r" x="5" y="7"/><defs><rect id="r" width="10" height="10"/></defs></g>`, '5 7 15 17']])
  console.log(`${content}: ${measured(content)[1]}, right ${right}`);
JS
node boxes.mjs >seen
expect_in seen <<'END'
M10 0A10 10 0 0 1 -10 0: box -10.0 0.0 10.0 10.0, right -10.0 0.0 10.0 10.0; half of 31.4 at 0.0 10.0, right 0.0 10.0
M20 0A20 10 0 0 1 -20 0: box -20.0 0.0 20.0 20.0, right -20.0 0.0 20.0 10.0; half of 48.4 at 0.0 20.0, right 0.0 10.0
M20 0A20 10 30 0 1 -20 0: box -20.0 0.0 23.8 23.8, right -20.0 0.0 23.9 17.5; half of 64.1 at 13.0 20.0, right 13.0 17.5
<ellipse cx="5" cy="6" rx="4" ry="2"/>: 1.0 2.0 9.0 10.0, right 1 4 9 8
<circle cx="5" cy="6" r="4"/>: 1.0 2.0 9.0 10.0, right 1 2 9 10
<g><rect width="10" height="10"/><rect x="50" width="10" height="10" display="none"/></g>: 0.0 0.0 60.0 10.0, right 0 0 10 10
<g><rect width="10" height="10"/><clipPath id="c"><rect x="50" width="10" height="10"/></clipPath></g>: 0.0 0.0 60.0 10.0, right 0 0 10 10
<g><rect width="10" height="10"/><symbol id="s"><rect x="50" width="10" height="10"/></symbol></g>: 0.0 0.0 60.0 10.0, right 0 0 10 10
<g><use href="#r" x="5" y="7"/><defs><rect id="r" width="10" height="10"/></defs></g>: 0.0 0.0 10.0 10.0, right 5 7 15 17
END
