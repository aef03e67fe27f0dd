#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-intersections 0.4.0 (npm) finds nothing on the horizontal and vertical lines (H, V) of a path: an outline written by them is met once,
# on its last side, by a line that crosses it twice, and not at all by an upright one. Nothing is said. The same outline by L, <rect> and
# <polygon>, circles and arcs are met where they are. Believed: as SVG 1.1, 8.3.4 has H and V, so that it makes no difference how lines are written.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-intersections@0.4.0
cat >meet.js <<'JS'
const { intersect, shape } = require("svg-intersections");
const line = (x1, y1, x2, y2) => shape("line", { x1, y1, x2, y2 });
for (const [what, kind, values] of [
  ["rectangle", "rect", { x: 0, y: 0, width: 40, height: 20 }],
  ["path by L", "path", { d: "M0 0L40 0L40 20L0 20Z" }],
  ["path by H and V", "path", { d: "M0 0H40V20H0Z" }],
  ["plate with round corners", "path", { d: "M5 0H35A5 5 0 0 1 40 5V15A5 5 0 0 1 35 20H5A5 5 0 0 1 0 15V5A5 5 0 0 1 5 0Z" }],
  ["its lines by L", "path", { d: "M5 0L35 0A5 5 0 0 1 40 5L40 15A5 5 0 0 1 35 20L5 20A5 5 0 0 1 0 15L0 5A5 5 0 0 1 5 0Z" }],
]) {
  const points = (other) => intersect(shape(kind, values), other).points.map((p) => `(${+p.x.toFixed(3)}, ${+p.y.toFixed(3)})`).sort().join(" ") || "nowhere";
  console.log(`${what}: y = 8 meets it at ${points(line(-5, 8, 50, 8))}, x = 20 at ${points(line(20, -5, 20, 25))}`);
}
JS
node meet.js >seen
expect_in seen <<'END'
rectangle: y = 8 meets it at (0, 8) (40, 8), x = 20 at (20, 0) (20, 20)
path by L: y = 8 meets it at (0, 8) (40, 8), x = 20 at (20, 0) (20, 20)
path by H and V: y = 8 meets it at (0, 8), x = 20 at nowhere
plate with round corners: y = 8 meets it at nowhere, x = 20 at nowhere
its lines by L: y = 8 meets it at (0, 8) (40, 8), x = 20 at (20, 0) (20, 20)
END
