#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-reverse 1.7.0, by which plotters and cutters turn the direction of outlines, takes an m of several points, as Inkscape and SVGO
# write it, as if the second began where the first ended: all that follows stands off by the first point (10, 10 here), and the path is
# longer. An M of several points, and h, v, c, q, z after a single m, keep their place. Nothing is said. Believed: the same outline, run
# backwards: further points of an m are relative lines (SVG 1.1, 8.3.2).
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-reverse@1.7.0 svg-path-bbox@2.1.0
cat >turn.cjs <<'JS'
const { svgPathBbox } = require("svg-path-bbox");
const { reverse } = require("svg-path-reverse");
const box = (path) => "box " + svgPathBbox(path).map((value) => +value.toFixed(3)).join(" ");
for (const path of ["M 10 10 20 10 20 20", "m 10 10 h 10 v 10 z m 30 0 h 10 v 10 z", "m 10 10 10 0 0 10", "m 10 10 10 0 0 10 z m 30 0 10 0 0 10 z"])
  console.log(`${path}: ${box(path)}; reversed ${box(reverse(path))}: ${reverse(path)}`);
JS
node turn.cjs >seen
expect_in seen <<'END'
M 10 10 20 10 20 20: box 10 10 20 20; reversed box 10 10 20 20: M 20 20 L 20 10 L 10 10 L 10 10
m 10 10 h 10 v 10 z m 30 0 h 10 v 10 z: box 10 10 50 20; reversed box 10 10 50 20: M 50 20 L 50 10 L 40 10 Z M 20 20 L 20 10 L 10 10 Z
m 10 10 10 0 0 10: box 10 10 20 20; reversed box 10 10 30 30: M 30 30 L 30 20 L 20 20 L 10 10
m 10 10 10 0 0 10 z m 30 0 10 0 0 10 z: box 10 10 50 20; reversed box 10 10 80 30: M 80 20 L 80 10 L 70 10 L 40 10 Z M 30 30 L 30 20 L 20 20 L 10 10 Z
END
