#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# zrender 6.1.0 (below ECharts) breaks arcs that it transforms (transformPath): the half of a circle that is mirrored becomes a point, a turned quarter
# another arc that does not begin where it should, and skewed ones keep their axes. Moves and even scales, lines and curves are
# right. Boxes of turned ellipses are elsewhere even without a transform. Nothing is said. Believed: as each point moves.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages zrender@6.1.0 svgpath@2.6.0 svg-path-bbox@2.1.0
cat >arcs.mjs <<'JS'
import { svgPathBbox } from 'svg-path-bbox';
import svgpath from 'svgpath';
import { createFromString } from 'zrender/lib/tool/path.js';
import transformPath from 'zrender/lib/tool/transformPath.js';

// The points at which zrender draws arcs and curves: the calls that a canvas would get.
function drawn(path) {
  const points = [];
  path.rebuildPath({
    beginPath() {}, closePath() {}, lineTo: (x, y) => points.push([x, y]), moveTo: (x, y) => points.push([x, y]),
    arc(x, y, radius, from, to, back) { this.ellipse(x, y, radius, radius, 0, from, to, back); },
    bezierCurveTo(...c) {
      const [x, y] = points.at(-1);
      for (let t = 0; t <= 1; t += 0.01) points.push([x, y].map((it, k) => (1 - t) ** 3 * it + 3 * t * (1 - t) ** 2 * c[k] + 3 * t * t * (1 - t) * c[2 + k] + t ** 3 * c[4 + k]));
    },
    ellipse(x, y, rx, ry, turn, from, to, back) {
      const whole = 2 * Math.PI, way = back ? -((from - to) % whole + whole) % whole : ((to - from) % whole + whole) % whole;
      for (let i = 0; i <= 1000; ++i) {
        const u = rx * Math.cos(from + way * i / 1000), v = ry * Math.sin(from + way * i / 1000);
        points.push([x + u * Math.cos(turn) - v * Math.sin(turn), y + u * Math.sin(turn) + v * Math.cos(turn)]);
      }
    },
  }, 1);
  return points;
}
const text = (x0, y0, x1, y1) => `${[x0, x1].map((it) => it.toFixed(1)).join('..')} ${[y0, y1].map((it) => it.toFixed(1)).join('..')}`.replace(/-0\.0\b/g, '0.0');
for (const [name, d] of [['half circle', 'M10 0A10 10 0 0 1 -10 0'], ['quarter', 'M10 0A10 10 0 0 1 0 10'], ['turned ellipse', 'M0 0A20 10 45 0 1 20 0'], ['curve', 'M0 0C0 10 10 10 10 0']])
  for (const [change, matrix] of [['as it is', [1, 0, 0, 1, 0, 0]], ['moved', [1, 0, 0, 1, 5, 7]], ['turned', [0.8, 0.6, -0.6, 0.8, 0, 0]], ['mirrored', [-1, 0, 0, 1, 0, 0]], ['skewed', [1, 0, 0.5, 1, 0, 0]]]) {
    const shape = createFromString(d);
    shape.createPathProxy();
    shape.buildPath(shape.path, shape.shape);
    transformPath(shape.path, matrix);
    const points = drawn(shape.path), { x, y, width, height } = shape.path.getBoundingRect();
    const ends = [0, 1].map((axis) => [Math.min(...points.map((it) => it[axis])), Math.max(...points.map((it) => it[axis]))]);
    console.log(`${name} ${change}: drawn ${text(ends[0][0], ends[1][0], ends[0][1], ends[1][1])}, box ${text(x, y, x + width, y + height)}, right ${text(...svgPathBbox(String(svgpath(d).matrix(matrix))))}`);
  }
JS
node arcs.mjs >seen
expect_in seen <<'END'
half circle as it is: drawn -10.0..10.0 0.0..10.0, box -10.0..10.0 0.0..10.0, right -10.0..10.0 0.0..10.0
half circle moved: drawn -5.0..15.0 7.0..17.0, box -5.0..15.0 7.0..17.0, right -5.0..15.0 7.0..17.0
half circle turned: drawn -2.8..10.0 -6.0..10.0, box -2.8..10.0 -6.0..10.0, right -10.0..8.0 -6.0..10.0
half circle mirrored: drawn -10.0..-10.0 0.0..0.0, box -10.0..-10.0 0.0..0.0, right -10.0..10.0 0.0..10.0
half circle skewed: drawn -10.0..10.0 0.0..11.2, box -10.0..10.0 0.0..11.2, right -10.0..11.2 0.0..10.0
quarter as it is: drawn 0.0..10.0 0.0..10.0, box 0.0..10.0 0.0..10.0, right 0.0..10.0 0.0..10.0
quarter moved: drawn 5.0..15.0 7.0..17.0, box 5.0..15.0 7.0..17.0, right 5.0..15.0 7.0..17.0
quarter turned: drawn 8.0..10.0 -6.0..6.0, box 8.0..10.0 -6.0..6.0, right -6.0..8.0 6.0..10.0
quarter mirrored: drawn -10.0..10.0 -10.0..10.0, box -10.0..10.0 -10.0..10.0, right -10.0..0.0 0.0..10.0
quarter skewed: drawn 0.0..10.0 0.0..11.2, box 0.0..10.0 0.0..11.2, right 5.0..11.2 0.0..10.0
turned ellipse as it is: drawn 0.0..20.0 -6.1..0.0, box -4.2..11.9 -0.1..14.0, right 0.0..20.0 -6.1..0.0
turned ellipse moved: drawn 5.0..25.0 0.9..7.0, box 0.8..16.9 6.9..21.0, right 5.0..25.0 0.9..7.0
turned ellipse turned: drawn 0.0..3.0 -5.0..9.4, box -4.2..6.6 0.0..18.6, right 0.0..16.0 -2.6..12.0
turned ellipse mirrored: drawn 0.0..31.6 -6.1..25.5, box -4.2..35.8 -0.1..19.7, right -20.0..0.0 -6.1..0.0
turned ellipse skewed: drawn -0.4..20.8 -5.4..1.5, box -4.2..11.9 -0.1..15.7, right -0.9..20.0 -6.1..0.0
curve as it is: drawn 0.0..10.0 0.0..7.5, box 0.0..10.0 0.0..7.5, right 0.0..10.0 0.0..7.5
curve moved: drawn 5.0..15.0 7.0..14.5, box 5.0..15.0 7.0..14.5, right 5.0..15.0 7.0..14.5
curve turned: drawn -2.1..7.8 0.0..9.8, box -2.1..8.0 0.0..9.8, right -2.1..8.0 0.0..9.8
curve mirrored: drawn -10.0..0.0 0.0..7.5, box -10.0..0.0 0.0..7.5, right -10.0..0.0 0.0..7.5
curve skewed: drawn 0.0..11.4 0.0..7.5, box 0.0..11.4 0.0..7.5, right 0.0..11.4 0.0..7.5
END
