#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-pathdata 9.0.0 rounds each relative coordinate of a path for itself, so that errors add up: a circle of 360 short lines, radius 10,
# rounded to tenths (round(10)) is 20.8 wide and reaches to -10.8, rounded to whole numbers it is a point. Its end is not its beginning.
# Absolute coordinates are right, and so is svgpath 2.6.0, which carries what it cut off over to the next. Nothing is said. Believed: each
# point moves by no more than half a unit of the last digit.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-pathdata@9.0.0 svgpath@2.6.0 svg-path-bbox@2.1.0
cat >round.mjs <<'JS'
import { SVGPathData } from "svg-pathdata";
import { svgPathBbox } from "svg-path-bbox";
import svgpath from "svgpath";
const at = (i) => [10 * Math.cos(i * Math.PI / 180), 10 * Math.sin(i * Math.PI / 180)];
let circle = "m10 0";
for (let i = 0; i < 360; ++i) circle += `l${at(i + 1)[0] - at(i)[0]} ${at(i + 1)[1] - at(i)[1]}`;
const box = (path) => svgPathBbox(path).map((value) => +value.toFixed(3) + 0).join(" ");
for (const digits of [0, 1, 2]) {
  console.log(`relative, ${digits} digits: ${box(new SVGPathData(circle).round(10 ** digits).encode())}`);
  console.log(`absolute, ${digits} digits: ${box(new SVGPathData(circle).toAbs().round(10 ** digits).encode())}`);
  console.log(`svgpath, ${digits} digits: ${box(svgpath(circle).round(digits).toString())}`);
}
JS
node round.mjs >seen
expect_in seen <<'END'
relative, 0 digits: 10 0 10 0
absolute, 0 digits: -10 -10 10 10
svgpath, 0 digits: -10 -10 10 10
relative, 1 digits: -10.8 -10.4 10 10.4
absolute, 1 digits: -10 -10 10 10
svgpath, 1 digits: -10 -10 10 10
relative, 2 digits: -9.92 -9.96 10 9.96
absolute, 2 digits: -10 -10 10 10
svgpath, 2 digits: -10 -10 10 10
END
