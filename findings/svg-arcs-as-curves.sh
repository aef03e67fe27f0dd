#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# path-data-parser 0.1.0 (below points-on-path 0.2.1 and rough.js) and @antv/util 3.3.11 make one cubic curve of up to 120 degrees of an arc of an
# SVG path: 1.5 mm off at a radius of 1 m, whatever the tolerance of pointsOnPath. svgpath 2.6.0 and svg-path-parse 1.1.3 divide at 90
# degrees: 0.27 mm. Believed: 0.27 mm, as usual (PDF has no arcs, either), and less than the tolerance where one is asked for.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages path-data-parser@0.1.0 points-on-path@0.2.1 @antv/util@3.3.11 svgpath@2.6.0 svg-path-parse@1.1.3
cat >arcs.cjs <<'JS'
const radius = 1000;
const arc = (angle) => `M${radius} 0A${radius} ${radius} 0 ${angle > 180 ? 1 : 0} 1 ${radius * Math.cos(angle * Math.PI / 180)} ${radius * Math.sin(angle * Math.PI / 180)}`;
const off = (point) => Math.abs(Math.hypot(...point) - radius);
const curves = (path) => [...path.matchAll(/([MC])([^A-Z]*)/g)].map(([, letter, values]) => [letter, ...values.match(/-?[\d.]+(e-?\d+)?/g).map(Number)]);
function deviation(segments) {
  let from = null, most = 0;
  for (const [letter, ...c] of segments) {
    if (letter === 'C')
      for (let t = 0; t <= 1; t += 0.01)
        most = Math.max(most, off([0, 1].map((k) => (1 - t) ** 3 * from[k] + 3 * t * (1 - t) ** 2 * c[k] + 3 * t * t * (1 - t) * c[2 + k] + t ** 3 * c[4 + k])));
    from = c.slice(-2);
  }
  return most.toFixed(2);
}
const { parsePath, absolutize, normalize } = require('path-data-parser');
const { pathParse, serializePath } = require('svg-path-parse');
const libraries = {
  'svgpath': (d) => curves(String(require('svgpath')(d).unarc().abs())),
  'svg-path-parse': (d) => curves(serializePath(pathParse(d).absNormalize({ transform: 'scale(1)' })).replace(/([C ,\d])-/g, '$1 -')),
  'path-data-parser': (d) => normalize(absolutize(parsePath(d))).map(({ key, data }) => [key, ...data]),
  '@antv/util': (d) => require('@antv/util').path2Curve(d),
};
for (const [name, read] of Object.entries(libraries))
  console.log(`${name}, arcs of 90, 120, 180 and 270 degrees of a radius of ${radius}: off by ${[90, 120, 180, 270].map((angle) => deviation(read(arc(angle)))).join(', ')}`);
for (const tolerance of [1, 0.1, 0.01]) {
  const [points] = require('points-on-path').pointsOnPath(arc(180), tolerance);
  console.log(`pointsOnPath with a tolerance of ${tolerance}: ${points.length} points, off by ${Math.max(...points.map(off)).toFixed(2)}`);
}
JS
node arcs.cjs >seen
expect_in seen <<'END'
svgpath, arcs of 90, 120, 180 and 270 degrees of a radius of 1000: off by 0.27, 0.02, 0.27, 0.27
svg-path-parse, arcs of 90, 120, 180 and 270 degrees of a radius of 1000: off by 0.27, 0.02, 0.27, 0.27
path-data-parser, arcs of 90, 120, 180 and 270 degrees of a radius of 1000: off by 0.27, 1.54, 1.54, 1.54
@antv/util, arcs of 90, 120, 180 and 270 degrees of a radius of 1000: off by 0.27, 1.54, 1.54, 1.54
pointsOnPath with a tolerance of 1: 98 points, off by 1.54
pointsOnPath with a tolerance of 0.1: 194 points, off by 1.54
pointsOnPath with a tolerance of 0.01: 386 points, off by 1.54
END
