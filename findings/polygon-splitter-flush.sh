#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# polygon-splitter 0.0.11 (npm), by which outlines are cut into pieces, computes other pieces where the cut runs along a side: of a plate of 96 with a
# hole, cut along a side of the hole, there are pieces of 56, 100 and 56, of a U cut along its floor one of 36 too many, and a cut from corner
# to corner leaves a piece without area. Two cuts that cross (MultiLineString, which its page names) make pieces of 50, 70 and 50 of a square
# of 100. Nothing is said. Cuts that pass by corners and sides are right. Believed: pieces that together are the plate.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages polygon-splitter@0.0.11
cat >split.js <<'JS'
const split = require("polygon-splitter");
const box = (x, y, width, height) => [[x, y], [x + width, y], [x + width, y + height], [x, y + height], [x, y]];
const plate = box(0, 0, 10, 10), channel = [[0, 0], [10, 0], [10, 10], [8, 10], [8, 2], [2, 2], [2, 10], [0, 10], [0, 0]];
const size = (ring) => Math.abs(ring.slice(1).reduce((sum, [x, y], i) => sum + ring[i][0] * y - x * ring[i][1], 0)) / 2;
for (const [name, rings, cuts, right] of [
  ["a square, through its sides", [plate], [[[3, -1], [3, 11]]], "30 70"],
  ["a square, from corner to corner", [plate], [[[-1, -1], [11, 11]]], "50 50"],
  ["a square, by two cuts that cross", [plate], [[[3, -1], [3, 11]], [[-1, 5], [11, 5]]], "15 15 35 35"],
  ["a plate, through its hole", [plate, box(4, 4, 2, 2)], [[[5, -1], [5, 11]]], "48 48"],
  ["a plate, along a side of its hole", [plate, box(4, 4, 2, 2)], [[[4, -1], [4, 11]]], "40 56"],
  ["a U, through its legs", [channel], [[[-1, 5], [11, 5]]], "10 10 32"],
  ["a U, along its floor", [channel], [[[-1, 2], [11, 2]]], "16 16 20"]]) {
  const geometry = split({ type: "Polygon", coordinates: rings }, { type: "MultiLineString", coordinates: cuts }).geometry;
  const pieces = geometry.type == "Polygon" ? [geometry.coordinates] : geometry.coordinates;
  const areas = pieces.map(([border, ...holes]) => size(border) - holes.reduce((sum, hole) => sum + size(hole), 0)).sort((a, b) => a - b);
  console.log(`${name}: ${areas.join(" ")}, right would be ${right}`);
}
JS
node split.js >seen
expect_in seen <<'END'
a square, through its sides: 30 70, right would be 30 70
a square, from corner to corner: 0 50 50, right would be 50 50
a square, by two cuts that cross: 50 50 70, right would be 15 15 35 35
a plate, through its hole: 48 48, right would be 48 48
a plate, along a side of its hole: 56 56 100, right would be 40 56
a U, through its legs: 10 10 32, right would be 10 10 32
a U, along its floor: 0 16 20 36, right would be 16 16 20
END
