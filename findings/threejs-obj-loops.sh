#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: OBJExporter writes of a LineLoop, such as the closed lines of a glTF (mode 2) become, its corners and no line, and of what
# is derived from LineSegments (BoxHelper, AxesHelper) as little. Lines and LineSegments are right. Nothing is said. Believed: the lines
# that are drawn.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >lines.mjs <<'JS'
import { BoxGeometry, BoxHelper, BufferGeometry, Line, LineLoop, LineSegments, Mesh, Vector3 } from "three";
import { OBJExporter } from "three/examples/jsm/exporters/OBJExporter.js";
const corners = (count) => new BufferGeometry().setFromPoints([...Array(count)].map((_, i) => new Vector3(i, i * i, 0)));
const cases = {
  "segments, 4 corners": [new LineSegments(corners(4)), "1-2 3-4"],
  "line, 3 corners": [new Line(corners(3)), "1-2-3"],
  "loop, 3 corners": [new LineLoop(corners(3)), "1-2-3-1"],
  "box of BoxHelper": [new BoxHelper(new Mesh(new BoxGeometry(1, 1, 1))), "its 12 edges"],
};
for (const [name, [shape, right]] of Object.entries(cases)) {
  const text = new OBJExporter().parse(shape), written = [...text.matchAll(/^l (.*)$/gm)].map((match) => match[1].trim().replaceAll(" ", "-"));
  console.log(`${name}: ${text.match(/^v /gm).length} corners, ${written.join(" ") || "no line"}; right would be ${right}`);
}
JS
node lines.mjs >seen
expect_in seen <<'END'
segments, 4 corners: 4 corners, 1-2 3-4; right would be 1-2 3-4
line, 3 corners: 3 corners, 1-2-3; right would be 1-2-3
loop, 3 corners: 3 corners, no line; right would be 1-2-3-1
box of BoxHelper: 8 corners, no line; right would be its 12 edges
END
