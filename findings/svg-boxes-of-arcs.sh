#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Boxes of SVG paths with arcs: npm's svg-path-bounds 1.0.2 takes the control points of the curves that it makes of an arc, so that its box
# is up to 0.5 mm too large around most of a circle of 10 mm; svg-path-commander 2.3.3 puts arcs whose axes are turned by more than 90 degrees
# elsewhere, where a view box taken from it shows little of them. svg-pathdata 7.2.0 is right. Believed: all three are.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-bounds@1.0.2 svg-path-commander@2.3.3 svg-pathdata@7.2.0
cat >boxes.mjs <<'JS'
import bounds from 'svg-path-bounds';
import Commander from 'svg-path-commander';
import { SVGPathData } from 'svg-pathdata';

const say = (name, box) => console.log(`  ${name}: ${box.map((value) => (Math.round(value * 100) / 100 + 0).toFixed(2)).join(' ')}`);
for (const [name, path] of [
  ['most of a circle of 10 mm', 'M0 0A5 5 0 1 1 6 0'],
  ['ellipse turned by 30 degrees', 'M0 0A20 10 30 0 1 30 10'],
  ['ellipse turned by 135 degrees', 'M0 0A10 5 135 0 1 5 7'],
]) {
  console.log(name);
  say('svg-path-bounds', bounds(path));
  const box = Commander.getPathBBox(path);
  say('svg-path-commander', [box.x, box.y, box.x2, box.y2]);
  const { minX, minY, maxX, maxY } = new SVGPathData(path).getBounds();
  say('svg-pathdata', [minX, minY, maxX, maxY]);
}
JS
node boxes.mjs >seen
expect_in seen <<'END'
most of a circle of 10 mm
  svg-path-bounds: -2.42 -9.00 8.42 0.00
  svg-path-commander: -2.00 -9.00 8.00 0.00
  svg-pathdata: -2.00 -9.00 8.00 0.00
ellipse turned by 30 degrees
  svg-path-bounds: 0.00 -2.36 30.00 10.00
  svg-path-commander: 0.00 -1.77 30.00 10.00
  svg-pathdata: 0.00 -1.77 30.00 10.00
ellipse turned by 135 degrees
  svg-path-bounds: 0.00 -1.25 7.01 7.00
  svg-path-commander: -9.25 0.00 5.00 14.95
  svg-pathdata: 0.00 -0.86 6.56 7.00
END
