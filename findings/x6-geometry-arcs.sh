#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @antv/x6-geometry 2.0.5 (Path.parse) ends arcs of an SVG path of more than 120 degrees too early: of a half circle two thirds are left, and a
# line that follows begins there. Boxes and lengths are those of what is left. A path whose arc flags have nothing between, as SVGO
# writes them, has no segment. Nothing is said. Arcs up to 120 degrees, curves and lines are right. Believed: the whole arc.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @antv/x6-geometry@2.0.5 svg-path-bbox@2.1.0 svg-path-properties@2.1.0
cat >arcs.mjs <<'JS'
import { Path } from '@antv/x6-geometry';
import { svgPathBbox } from 'svg-path-bbox';
import { svgPathProperties } from 'svg-path-properties';

const point = (angle) => [Math.cos(angle * Math.PI / 180), Math.sin(angle * Math.PI / 180)].map((it) => (10 * it).toFixed(6)).join(' ');
const arc = (angle) => `M10 0A10 10 0 ${angle > 180 ? 1 : 0} 1 ${point(angle)}`;
const box = (...ends) => ends.map((it) => it.toFixed(1).replace('-0.0', '0.0')).join(' ');
for (const [name, d] of [['90 degrees', arc(90)], ['120 degrees', arc(120)], ['130 degrees', arc(130)], ['half circle', arc(180)], ['270 degrees', arc(270)], ['slot', 'M0 0H20A5 5 0 0 1 20 10H0A5 5 0 0 1 0 0Z'],
  ['flags in one', 'M10 0a10 10 0 01-20 0'], ['curve', 'M0 0C0 10 20 10 20 0']]) {
  const path = Path.parse(d), { x, y, width, height } = path.bbox() ?? { x: 0, y: 0, width: 0, height: 0 };
  console.log(`${name}: length ${path.length({ precision: 5 }).toFixed(1)}, box ${box(x, y, x + width, y + height)}; right ${new svgPathProperties(d).getTotalLength().toFixed(1)}, ${box(...svgPathBbox(d))}`);
}
JS
node arcs.mjs >seen
expect_in seen <<'END'
90 degrees: length 15.7, box 0.0 0.0 10.0 10.0; right 15.7, 0.0 0.0 10.0 10.0
120 degrees: length 21.0, box -5.0 0.0 10.0 10.0; right 20.9, -5.0 0.0 10.0 10.0
130 degrees: length 21.0, box -5.0 0.0 10.0 10.0; right 22.7, -6.4 0.0 10.0 10.0
half circle: length 21.0, box -5.0 0.0 10.0 10.0; right 31.4, -10.0 0.0 10.0 10.0
270 degrees: length 41.9, box -10.0 -8.7 10.0 10.0; right 47.1, -10.0 -10.0 10.0 10.0
slot: length 63.3, box -1.7 0.0 25.0 7.5; right 71.4, -5.0 0.0 25.0 10.0
flags in one: length 0.0, box 10.0 0.0 10.0 0.0; right 31.4, -10.0 0.0 10.0 10.0
curve: length 27.9, box 0.0 0.0 20.0 7.5; right 27.9, 0.0 0.0 20.0 7.5
END
