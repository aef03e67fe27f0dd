#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# obj-file-parser 0.6.2 (npm) takes the backslash that continues a line of an OBJ for a number, and what follows for nothing: a face of four corners
# has two and one that is no number. Relative references count from the first corner of their object, whereas absolute ones count from the
# first of the file, so that the faces of a second object are those of the first. Nothing is said. Believed: as the format has it, "statements
# can be logically joined with the line continuation character", and references by number mean the same corners as those backwards.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages obj-file-parser@0.6.2
cat >read.js <<'JS'
const Reader = require("obj-file-parser");
const corners = (z) => `v 0 0 ${z}\nv 10 0 ${z}\nv 10 10 ${z}\nv 0 10 ${z}\n`;
for (const [what, text, right] of [
  ["one line", corners(0) + "f 1 2 3 4\n", "1 2 3 4"],
  ["continued line", corners(0) + "f 1 2 \\\n3 4\n", "1 2 3 4"],
  ["backwards", corners(0) + "f -4 -3 -2 -1\n", "1 2 3 4"],
  ["two objects by number", "o low\n" + corners(0) + "f 1 2 3 4\no high\n" + corners(5) + "f 5 6 7 8\n", "1 2 3 4, 5 6 7 8"],
  ["two objects backwards", "o low\n" + corners(0) + "f -4 -3 -2 -1\no high\n" + corners(5) + "f -4 -3 -2 -1\n", "1 2 3 4, 5 6 7 8"],
]) {
  const faces = new Reader(text).parse().models.flatMap((model) => model.faces.map((face) => face.vertices.map((vertex) => vertex.vertexIndex).join(" ")));
  console.log(`${what}: ${faces.join(", ")}, right is ${right}`);
}
JS
node read.js >seen
expect_in seen <<'END'
one line: 1 2 3 4, right is 1 2 3 4
continued line: 1 2 NaN, right is 1 2 3 4
backwards: 1 2 3 4, right is 1 2 3 4
two objects by number: 1 2 3 4, 5 6 7 8, right is 1 2 3 4, 5 6 7 8
two objects backwards: 1 2 3 4, 1 2 3 4, right is 1 2 3 4, 5 6 7 8
END
