#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# kld-intersections 0.7.0 mistakes where arcs of paths run: of the four arcs between two points, which a line meets at one point each, one
# is found to be met where it does not run, too, and one only there; an arc of most of a circle is met nowhere. Nothing is said. Circles,
# curves and half circles are right. Believed: one point each (SVG 1.1, 8.3.8).
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages kld-intersections@0.7.0
cat >meet.mjs <<'JS'
import { Intersection, ShapeInfo } from "kld-intersections";
const say = (what, shape, line, right) => {
  const points = Intersection.intersect(shape, line).points.map(({ x, y }) => `(${+x.toFixed(2)}, ${+y.toFixed(2)})`).sort();
  console.log(`${what}: ${points.join(" ") || "nowhere"}; right would be ${right}`);
};
const diagonal = ShapeInfo.line(-30, -30, 30, 30);
say("circle", ShapeInfo.circle(0, 0, 10), diagonal, "(-7.07, -7.07) (7.07, 7.07)");
say("curve", ShapeInfo.path("M10 0C10 5.523 5.523 10 0 10"), diagonal, "(7.07, 7.07)");
const arcs = { "0 1": "(7.07, 7.07)", "0 0": "(2.93, 2.93)", "1 0": "(-7.07, -7.07)", "1 1": "(17.07, 17.07)" };
for (const [flags, right] of Object.entries(arcs)) say(`M10 0A10 10 0 ${flags} 0 10`, ShapeInfo.path(`M10 0A10 10 0 ${flags} 0 10`), diagonal, right);
say("M0 -10A10 10 0 0 1 0 10", ShapeInfo.path("M0 -10A10 10 0 0 1 0 10"), diagonal, "(7.07, 7.07)");
say("M0 10A10 10 0 0 0 0 -10, the same backwards", ShapeInfo.path("M0 10A10 10 0 0 0 0 -10"), diagonal, "(7.07, 7.07)");
say("M0 10A10 10 0 1 1 7.07 7.07, most of a circle", ShapeInfo.path("M0 10A10 10 0 1 1 7.07 7.07"), ShapeInfo.line(-30, 0, 30, 0), "(-10, 0) (10, 0)");
JS
node meet.mjs >seen
expect_in seen <<'END'
circle: (-7.07, -7.07) (7.07, 7.07); right would be (-7.07, -7.07) (7.07, 7.07)
curve: (7.07, 7.07); right would be (7.07, 7.07)
M10 0A10 10 0 0 1 0 10: (7.07, 7.07); right would be (7.07, 7.07)
M10 0A10 10 0 0 0 0 10: (17.07, 17.07) (2.93, 2.93); right would be (2.93, 2.93)
M10 0A10 10 0 1 0 0 10: (-7.07, -7.07); right would be (-7.07, -7.07)
M10 0A10 10 0 1 1 0 10: (2.93, 2.93); right would be (17.07, 17.07)
M0 -10A10 10 0 0 1 0 10: (7.07, 7.07); right would be (7.07, 7.07)
M0 10A10 10 0 0 0 0 -10, the same backwards: (7.07, 7.07); right would be (7.07, 7.07)
M0 10A10 10 0 1 1 7.07 7.07, most of a circle: nowhere; right would be (-10, 0) (10, 0)
END
