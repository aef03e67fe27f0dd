#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-properties 2.1.0 and @remotion/paths 4.0.529 give tangents of arcs that point back to where the path comes from, and lean a
# little; of lines and curves they are right. What is aligned to an arc by them, such as an arrowhead at the end of a dimension of an angle,
# points the wrong way. Points on elliptical arcs are those at a share of the angle, not of the length. Believed: along the path, as its
# points run, and points at the length.
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
// The half of an ellipse that is 40 wide and 10 high, measured by 100000 chords.
const at = (t) => [20 * Math.cos(t), 10 * Math.sin(t)], chords = Array.from({ length: 100001 }, (_, i) => at(Math.PI * i / 100000)), lengths = [0];
for (let i = 1; i <= 100000; ++i) lengths.push(lengths[i - 1] + Math.hypot(chords[i][0] - chords[i - 1][0], chords[i][1] - chords[i - 1][1]));
for (const part of [0.1, 0.25, 0.5]) {
  const d = 'M20 0A20 10 0 0 1 -20 0', path = new svgPathProperties(d), length = path.getTotalLength() * part;
  const text = (x, y) => `${x.toFixed(2)} ${Math.abs(y).toFixed(2)}`, right = chords[lengths.findIndex((it) => it >= length)];
  const [one, other] = [path.getPointAtLength(length), getPointAtLength(d, length)].map(({ x, y }) => text(Math.abs(x), y));
  console.log(`half ellipse, at ${part} of its length of ${path.getTotalLength().toFixed(2)} (right ${lengths.at(-1).toFixed(2)}): svg-path-properties ${one}, @remotion/paths ${other}, right ${text(Math.abs(right[0]), right[1])}`);
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
half ellipse, at 0.1 of its length of 48.44 (right 48.44): svg-path-properties 19.02 3.09, @remotion/paths 19.02 3.09, right 18.05 4.31
half ellipse, at 0.25 of its length of 48.44 (right 48.44): svg-path-properties 14.14 7.07, @remotion/paths 14.14 7.07, right 11.89 8.04
half ellipse, at 0.5 of its length of 48.44 (right 48.44): svg-path-properties 0.00 10.00, @remotion/paths 0.00 10.00, right 0.00 10.00
END
