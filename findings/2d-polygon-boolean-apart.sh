#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# 2d-polygon-boolean 1.0.1 (npm) gives both outlines for the first less the second where they do not meet: what was to be cut off is added. Cuts
# that cross a side, and pockets within, are right, so that one tool of several that misses the part shows up as another part. Their intersection
# is an error ("woops"). Nothing else is said. Believed: "cut", as its readme has it: the first one as it was.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages 2d-polygon-boolean@1.0.1
cat >cut.js <<'JS'
const boolean = require("2d-polygon-boolean");
const area = (points) => points.reduce((sum, [x, y], i) => sum + x * points[(i + 1) % points.length][1] - points[(i + 1) % points.length][0] * y, 0) / 2;
const box = (x, y, width, height) => [[x, y], [x + width, y], [x + width, y + height], [x, y + height]];
for (const [what, tool, right] of [
  ["a corner", box(6, 6, 8, 8), 84],
  ["a slot through", box(4, -5, 2, 20), 80],
  ["a pocket within", box(3, 3, 4, 4), 84],
  ["a tool beside", box(20, 0, 10, 10), 100],
  ["a tool 0.1 beside", box(10.1, 2, 5, 5), 100],
]) {
  const pieces = boolean(box(0, 0, 10, 10), tool, "not");
  const low = Math.min(...pieces.flat().map(([x]) => x)), high = Math.max(...pieces.flat().map(([x]) => x));
  // A pocket is another piece, which turns the other way.
  const inside = (p) => p.every(([x, y]) => x > 0 && x < 10 && y > 0 && y < 10);
  const sum = pieces.reduce((total, p) => total + (inside(p) ? -1 : 1) * Math.abs(area(p)), 0);
  console.log(`square of 10 less ${what}: ${pieces.length} outlines from x ${low} to ${high}, area ${sum}, right is ${right}`);
}
JS
node cut.js >seen
expect_in seen <<'END'
square of 10 less a corner: 1 outlines from x 0 to 10, area 84, right is 84
square of 10 less a slot through: 2 outlines from x 0 to 10, area 80, right is 80
square of 10 less a pocket within: 2 outlines from x 0 to 10, area 84, right is 84
square of 10 less a tool beside: 2 outlines from x 0 to 30, area 200, right is 100
square of 10 less a tool 0.1 beside: 2 outlines from x 0 to 15.1, area 125, right is 100
END
