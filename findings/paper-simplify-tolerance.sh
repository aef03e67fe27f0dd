#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# paper 0.12.20 (Path.simplify) and what @luncheon/simplify-svg-path 0.2.0 takes from it compare their tolerance, "the allowed maximum error", with
# squares of distances: 0.0001 leaves points of a circle 0.004 off, forty times as far, and 0.01 0.09; one above 1 allows less than it says.
# Believed: no point is farther from the simplified path than the tolerance.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages paper@0.12.20 @luncheon/simplify-svg-path@0.2.0
cat >simplify.mjs <<'JS'
import simplifySvgPath from '@luncheon/simplify-svg-path';
import paper from 'paper/dist/paper-core.js';

paper.setup([1, 1]);
for (const tolerance of [0.0001, 0.01, 1, 25]) {
  const points = Array.from({ length: 201 }, (_, i) => [100 * Math.cos(i * Math.PI / 100), 100 * Math.sin(i * Math.PI / 100)]);
  const simple = new paper.Path(points);
  simple.simplify(tolerance);
  const off = (path) => Math.max(...points.map((it) => path.getNearestPoint(it).getDistance(it))).toPrecision(2);
  console.log(`circle of radius 100, tolerance ${tolerance}: paper ${simple.segments.length} points, off by ${off(simple)}; ` +
    `simplify-svg-path off by ${off(new paper.Path(simplifySvgPath(points, { tolerance })))}`);
}
JS
node simplify.mjs >seen
expect_in seen <<'END'
circle of radius 100, tolerance 0.0001: paper 23 points, off by 0.0044; simplify-svg-path off by 0.0044
circle of radius 100, tolerance 0.01: paper 17 points, off by 0.094; simplify-svg-path off by 0.094
circle of radius 100, tolerance 1: paper 9 points, off by 0.74; simplify-svg-path off by 0.74
circle of radius 100, tolerance 25: paper 3 points, off by 3.3; simplify-svg-path off by 3.3
END
