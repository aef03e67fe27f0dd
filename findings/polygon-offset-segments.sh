#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# polygon-offset 0.3.2 (npm) loses a strip when the corners are rounded more finely: with 64 segments an arc a square of 10 with a margin
# of 1 covers 133.7, with 32 the 143.1 that it should, and its padding becomes two rings that cover 68.7 together instead of 64. Nothing is
# said. Believed: more segments come closer to 100 + 40 + pi, and a padding has no arcs.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages polygon-offset@0.3.2
cat >margin.js <<'JS'
const Offset = require("polygon-offset");
const square = [[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]];
const area = (points) => points.reduce((sum, [x, y], i) => sum + x * points[(i + 1) % points.length][1] - points[(i + 1) % points.length][0] * y, 0) / 2;
for (const kind of ["margin", "padding"])
  for (const segments of [5, 8, 16, 32, 64, 128]) {
    const rings = new Offset().data(square).arcSegments(segments)[kind](1);
    console.log(`${kind} of 1, ${segments} segments: ${rings.map((ring) => Math.abs(area(ring)).toFixed(2)).join(", ")}`);
  }
console.log(`right: ${(140 + Math.PI).toFixed(2)} and 64`);
JS
node margin.js >seen
expect_in seen <<'END'
margin of 1, 5 segments: 143.01
margin of 1, 8 segments: 143.08
margin of 1, 16 segments: 143.13
margin of 1, 32 segments: 143.14
margin of 1, 64 segments: 133.74
margin of 1, 128 segments: 133.76
padding of 1, 5 segments: 64.00
padding of 1, 8 segments: 64.00
padding of 1, 16 segments: 64.00
padding of 1, 32 segments: 64.00
padding of 1, 64 segments: 39.94, 28.72
padding of 1, 128 segments: 39.92, 28.76
right: 143.14 and 64
END
