#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-commander 2.3.3 (shapeToPathArray) makes the round corners of an SVG rectangle of smooth curves (s) whose first control point is their
# start: they lean to one side and lie up to 2.3 % of the radius outside of the circle, 0.23 mm at a radius of 10 mm. Of circles and
# ellipses it makes arcs. Believed: arcs, as SVG defines the corners (SVG 1.1, 9.2).
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-commander@2.3.3 svg-path-properties@2.1.0
cat >corners.mjs <<'JS'
import SVGPathCommander from 'svg-path-commander';
import { svgPathProperties } from 'svg-path-properties';

for (const shape of [{ type: 'circle', cx: 50, cy: 50, r: 10 }, { type: 'rect', x: 0, y: 0, width: 100, height: 50, rx: 10 }]) {
  const d = SVGPathCommander.pathToString(SVGPathCommander.shapeToPathArray(shape)), path = new svgPathProperties(d), length = path.getTotalLength();
  const [x, y] = shape.type === 'circle' ? [50, 50] : [90, 10];  // the middle of the circle, or of the corner on the right at the top
  const off = [];
  for (let i = 0; i <= 10000; ++i) {
    const point = path.getPointAtLength(length * i / 10000);
    if (shape.type === 'circle' || (point.x > x && point.y < y)) off.push(Math.hypot(point.x - x, point.y - y) - 10);
  }
  console.log(`${shape.type}: ${d}; from a circle of radius 10 ${Math.min(...off).toFixed(2)} to ${Math.max(...off).toFixed(2)}`);
}
JS
node corners.mjs >seen
expect_in seen <<'END'
circle: M40 50a10 10 0 1 0 20 0a10 10 0 1 0 -20 0; from a circle of radius 10 -0.00 to 0.00
rect: M10 0h80s10 0 10 10v30s0 10 -10 10h-80s-10 0 -10 -10v-30s0 -10 10 -10; from a circle of radius 10 -0.03 to 0.23
END
