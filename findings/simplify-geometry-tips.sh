#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# simplify-geometry 0.0.2 (npm) measures how far a corner is off from the line on which an edge lies, however far beyond the ends of the edge: a line
# to 50 and back to 10 becomes one to 10, 40 off at a tolerance of 0.5, and one that overshoots both its ends loses both tips. Nothing is said.
# simplify-path 1.1.0 keeps them. Believed: no corner that goes is farther from what stays than the tolerance, as Douglas and Peucker have it.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages simplify-geometry@0.0.2 simplify-path@1.1.0
cat >lines.js <<'JS'
const simplifiers = { 'simplify-geometry': require('simplify-geometry'), 'simplify-path': require('simplify-path').douglasPeucker };
const toSegment = ([x, y], [a, b], [c, d]) => {
  const t = Math.min(1, Math.max(0, ((x - a) * (c - a) + (y - b) * (d - b)) / ((c - a) ** 2 + (d - b) ** 2 || 1)));
  return Math.hypot(a + t * (c - a) - x, b + t * (d - b) - y);
};
const off = (points, kept) => Math.max(...points.map((p) => Math.min(...kept.slice(1).map((q, i) => toSegment(p, kept[i], q)))));
for (const [name, points] of [
  ['there and back', [[0, 0], [50, 0.2], [10, 0]]], ['both ends overshot', [[20, 0], [0, 0], [60, 0.3], [40, 0.3]]],
  ['zigzag', [[0, 0], [10, 3], [20, 0], [30, 3], [40, 0]]], ['nearly straight', [[0, 0], [10, 0.2], [20, 0], [30, 0.2], [40, 0]]]])
  for (const [who, simplify] of Object.entries(simplifiers)) {
    const kept = simplify(points, 0.5);
    console.log(`${name}, ${who}: ${kept.map((p) => p.join(' ')).join(', ')}; ${off(points, kept).toFixed(1)} off for 0.5`);
  }
JS
node lines.js >seen
expect_in seen <<'END'
there and back, simplify-geometry: 0 0, 10 0; 40.0 off for 0.5
there and back, simplify-path: 0 0, 50 0.2, 10 0; 0.0 off for 0.5
both ends overshot, simplify-geometry: 20 0, 40 0.3; 20.0 off for 0.5
both ends overshot, simplify-path: 20 0, 0 0, 60 0.3, 40 0.3; 0.0 off for 0.5
zigzag, simplify-geometry: 0 0, 10 3, 20 0, 30 3, 40 0; 0.0 off for 0.5
zigzag, simplify-path: 0 0, 10 3, 20 0, 30 3, 40 0; 0.0 off for 0.5
nearly straight, simplify-geometry: 0 0, 40 0; 0.2 off for 0.5
nearly straight, simplify-path: 0 0, 40 0; 0.2 off for 0.5
END
