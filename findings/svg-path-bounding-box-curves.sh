#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-bounding-box 1.0.4 gives wrong boxes of paths that have more than one quadratic curve, as outlines of TrueType letters do: a wave
# from -10 to 10 is one from -2.5 to 12.3, of two arches of 10 beside each other the second is 18.2 high. One curve alone, cubic ones and
# arcs are right. Nothing is said. Believed: as svg-path-bbox, and by hand.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-bounding-box@1.0.4 svg-path-bbox@2.1.0
cat >box.cjs <<'JS'
const { svgPathBbox } = require("svg-path-bbox");
const measure = require("svg-path-bounding-box");
const text = (values) => values.map((value) => +value.toFixed(2)).join(" ");
for (const path of ["M0 0Q10 20 20 0", "M0 0C0 10 10 10 10 0S20 -10 20 0", "M0 0Q10 20 20 0Q30 -20 40 0", "M0 0q10 20 20 0t20 0", "M0 0Q10 20 20 0Q30 20 40 0", "M0 0Q10 20 20 0M100 0Q110 20 120 0"]) {
  const { minX, minY, maxX, maxY } = measure(path);
  console.log(`${path}: ${text([minX, minY, maxX, maxY])}, svg-path-bbox ${text(svgPathBbox(path))}`);
}
JS
node box.cjs >seen
expect_in seen <<'END'
M0 0Q10 20 20 0: 0 0 20 10, svg-path-bbox 0 0 20 10
M0 0C0 10 10 10 10 0S20 -10 20 0: 0 -7.5 20 7.5, svg-path-bbox 0 -7.5 20 7.5
M0 0Q10 20 20 0Q30 -20 40 0: 0 -2.47 40 12.26, svg-path-bbox 0 -10 40 10
M0 0q10 20 20 0t20 0: 0 -2.47 40 12.26, svg-path-bbox 0 -10 40 10
M0 0Q10 20 20 0Q30 20 40 0: 0 0 40 18.24, svg-path-bbox 0 0 40 10
M0 0Q10 20 20 0M100 0Q110 20 120 0: 0 0 120 53.47, svg-path-bbox 0 0 120 10
END
