#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-round-corners 0.1.5 (npm) begins and ends a rounding where an arc of the radius would, and draws a parabola between: asked for a radius of 30 it
# has one of 21.2 at the tip of a right angle, where it lies 1.8 outside of the arc, and of 15, 7.5 outside, at a corner of 60 degrees. Further
# points of an M, which are lines (SVG 1.1, 8.3.2), become moves, so that outlines as SVGO writes them vanish. Nothing is said. Believed:
# arcs of the radius that "roundCorners(path, radius)" names, and lines.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-round-corners@0.1.5
cat >round.js <<'JS'
const { parse } = require("svg-path-round-corners/dist/es5/parse");
const { roundCorners } = require("svg-path-round-corners/dist/es5/index");
const { serialize } = require("svg-path-round-corners/dist/es5/serialize");
for (const degrees of [60, 90, 120]) {
  const angle = (degrees * Math.PI) / 180, end = [100 - 100 * Math.cos(angle), 100 * Math.sin(angle)];
  const [, start, curve] = roundCorners(parse(`M0 0L100 0L${end.join(" ")}`), 30);
  // In its middle a quadratic curve runs along its chord, and its second derivative is the same all along it.
  const chord = [curve.x - start.x, curve.y - start.y], bend = [2 * (start.x - 2 * curve.x1 + curve.x), 2 * (start.y - 2 * curve.y1 + curve.y)];
  const radius = Math.hypot(...chord) ** 3 / Math.abs(chord[0] * bend[1] - chord[1] * bend[0]);
  const tip = Math.hypot((start.x + 2 * curve.x1 + curve.x) / 4 - 100, (start.y + 2 * curve.y1 + curve.y) / 4);
  console.log(`${degrees} degrees: radius at the tip ${radius.toFixed(1)}, ${tip.toFixed(1)} from the corner; an arc of radius 30 is ${(30 / Math.sin(angle / 2) - 30).toFixed(1)} from it`);
}
console.log(`lines by L: ${serialize(roundCorners(parse("M0 0L100 0L100 100"), 30))}`);
console.log(`lines after M: ${serialize(roundCorners(parse("M0 0 100 0 100 100"), 30))}`);
JS
node round.js >seen
expect_in seen <<'END'
60 degrees: radius at the tip 15.0, 22.5 from the corner; an arc of radius 30 is 30.0 from it
90 degrees: radius at the tip 21.2, 10.6 from the corner; an arc of radius 30 is 12.4 from it
120 degrees: radius at the tip 26.0, 4.3 from the corner; an arc of radius 30 is 4.6 from it
lines by L: M0 0L70 0Q100 0 100 30L100 100
lines after M: M0 0 100 0 100 100
END
