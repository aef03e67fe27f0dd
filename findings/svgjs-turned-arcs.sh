#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SVG.js 3.2.8 (PathArray.size) stretches the radii of arcs as though their axes were upright: the arc of a turned ellipse becomes another one, not as
# high as asked. Circles and curves have the size. The boxes that it measures before, by svgdom 0.1.29, are right here.
# Believed: the size, with each point moved as the rest.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @svgdotjs/svg.js@3.2.8 svgdom@0.1.29 svg-path-bbox@2.1.0 svgpath@2.6.0
cat >size.mjs <<'JS'
import { PathArray, registerWindow } from '@svgdotjs/svg.js';
import { svgPathBbox } from 'svg-path-bbox';
import { createSVGWindow } from 'svgdom';
import svgpath from 'svgpath';

const window = createSVGWindow();
registerWindow(window, window.document);
const text = ([x0, y0, x1, y1]) => `${(x1 - x0).toFixed(1)} x ${(y1 - y0).toFixed(1)}`;
for (const [name, d] of [['curve', 'M0 0C0 10 20 10 20 0'], ['half circle', 'M0 0A10 10 0 0 1 20 0'], ['arc of an ellipse turned by 45 degrees', 'M0 0A20 10 45 0 1 20 0']]) {
  const { width, height } = new PathArray(d).bbox(), sized = new PathArray(d).size(40, 40).toString();
  const right = String(svgpath(d).scale(40 / width, 40 / height));
  console.log(`${name}: measured ${width.toFixed(1)} x ${height.toFixed(1)} (right ${text(svgPathBbox(d))}), sized to 40 x 40: ${text(svgPathBbox(sized))}, by svgpath ${text(svgPathBbox(right))}`);
}
JS
node size.mjs >seen
expect_in seen <<'END'
curve: measured 20.0 x 7.5 (right 20.0 x 7.5), sized to 40 x 40: 40.0 x 40.0, by svgpath 40.0 x 40.0
half circle: measured 20.0 x 10.0 (right 20.0 x 10.0), sized to 40 x 40: 40.0 x 40.0, by svgpath 40.0 x 40.0
arc of an ellipse turned by 45 degrees: measured 20.0 x 6.1 (right 20.0 x 6.1), sized to 40 x 40: 40.0 x 4.9, by svgpath 40.0 x 40.0
END
