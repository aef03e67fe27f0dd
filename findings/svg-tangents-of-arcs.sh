#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-properties 2.1.0 and @remotion/paths 4.0.529 give tangents of arcs that point back to where the path comes from, and lean a
# little; of lines and curves, and the points of arcs, they are right. What is aligned to an arc by them, such as an arrowhead at the end
# of a dimension of an angle, points the wrong way. Believed: along the path, as its points run.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-properties@2.1.0 @remotion/paths@4.0.529
cat >tangents.mjs <<'JS'
import { getPointAtLength, getTangentAtLength } from '@remotion/paths';
import { svgPathProperties } from 'svg-path-properties';

const degrees = ({ x, y }) => Math.round(Math.atan2(y, x) * 180 / Math.PI);
for (const [name, d] of [['line', 'M0 0L20 0'], ['quadratic curve', 'M0 0Q10 10 20 0'], ['cubic curve', 'M0 0C0 10 20 10 20 0'],
  ['half circle', 'M0 0A10 10 0 0 1 20 0'], ['the other half', 'M0 0A10 10 0 0 0 20 0'], ['quarter', 'M10 0A10 10 0 0 1 0 10'], ['turned ellipse', 'M0 0A20 10 45 0 1 20 0']]) {
  const path = new svgPathProperties(d), at = path.getTotalLength() / 4;
  const before = getPointAtLength(d, at - 0.01), after = getPointAtLength(d, at + 0.01);
  console.log(`${name}: at a quarter of its length it runs at ${degrees({ x: after.x - before.x, y: after.y - before.y })} degrees; ` +
    `svg-path-properties ${degrees(path.getTangentAtLength(at))}, @remotion/paths ${degrees(getTangentAtLength(d, at))}`);
}
JS
node tangents.mjs >seen
expect_in seen <<'END'
line: at a quarter of its length it runs at 0 degrees; svg-path-properties 0, @remotion/paths 0
quadratic curve: at a quarter of its length it runs at 29 degrees; svg-path-properties 29, @remotion/paths 29
cubic curve: at a quarter of its length it runs at 32 degrees; svg-path-properties 32, @remotion/paths 32
half circle: at a quarter of its length it runs at -45 degrees; svg-path-properties 135, @remotion/paths 135
the other half: at a quarter of its length it runs at 45 degrees; svg-path-properties -135, @remotion/paths -135
quarter: at a quarter of its length it runs at 113 degrees; svg-path-properties -67, @remotion/paths -67
turned ellipse: at a quarter of its length it runs at -44 degrees; svg-path-properties 136, @remotion/paths 136
END
