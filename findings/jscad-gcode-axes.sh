#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/gcode-deserializer 0.2.1 (npm) leaves out every point of G-code with X0 or Y0: of a square of 20 with a corner in the origin a diagonal
# is left. It moves all by -100 -100, where beds have other middles, and takes inches (G20) for millimetres. Nothing is said. Squares away from
# the axes are whole. Believed: the lines that the file prints, wherever they lie.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/gcode-deserializer@0.2.1
cat >read.js <<'JS'
const { deserialize } = require("@jscad/gcode-deserializer");
const square = (x, y, more = "") => [0.2, 0.4, 0.6].map((z, layer) => {
  const corners = [[x + 20, y], [x + 20, y + 20], [x, y + 20], [x, y]];
  return `G1 Z${z}\nG1 X${x} Y${y}\n${corners.map(([u, v], k) => `G1 X${u} Y${v} E${4 * layer + k + 1}\n`).join("")}G1 X${x + 1} Y${y + 1}\n${more}`;
}).join("");
for (const [what, file] of [
  ["square from 5 5 to 25 25", "G21\nG90\nM82\nG1 X1 Y1 E0\n" + square(5, 5)],
  ["square from 0 0 to 20 20", "G21\nG90\nM82\nG1 X1 Y1 E0\n" + square(0, 0)],
  ["square from -10 -10 to 10 10", "G21\nG90\nM82\nG1 X1 Y1 E0\n" + square(-10, -10)],
  ["square from 5 5 to 25 25 in", "G20\nG90\nM82\nG1 X1 Y1 E0\n" + square(5, 5)],
]) {
  const text = deserialize(file, "part.gcode", { output: "jscad", version: "" });
  const paths = [...text.matchAll(/EX\(\[(.*?)\],\{/g)].map(([, points]) => points.replace(/ /g, ""));
  console.log(`${what}: ${paths.length} paths of three${paths.length ? ", " + [...new Set(paths)].join(" or ") : ""}`);
}
JS
node read.js >seen
expect_in seen <<'END'
square from 5 5 to 25 25: 3 paths of three, [-95,-95],[-75,-95],[-75,-75],[-95,-75],[-95,-95]
square from 0 0 to 20 20: 3 paths of three, [-99,-99],[-80,-80]
square from -10 -10 to 10 10: 3 paths of three, [-110,-110],[-90,-110],[-90,-90],[-110,-90],[-110,-110]
square from 5 5 to 25 25 in: 3 paths of three, [-95,-95],[-75,-95],[-75,-75],[-95,-75],[-95,-95]
END
