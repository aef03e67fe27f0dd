#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: PLYExporter leaves out all faces of a scene that has one Points object, such as marked centres: a box beside a point
# becomes 25 corners and no face. STLExporter and OBJExporter write the box. Nothing is said. Believed: 12 faces and a corner more.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >points.mjs <<'JS'
import { BoxGeometry, BufferGeometry, Mesh, Points, Scene, Vector3 } from "three";
import { OBJExporter } from "three/examples/jsm/exporters/OBJExporter.js";
import { PLYExporter } from "three/examples/jsm/exporters/PLYExporter.js";
import { STLExporter } from "three/examples/jsm/exporters/STLExporter.js";
const point = new Points(new BufferGeometry().setFromPoints([new Vector3(9, 9, 9)]));
for (const [name, parts] of [["box", []], ["box and point", [point]]]) {
  const scene = new Scene().add(new Mesh(new BoxGeometry(1, 1, 1)), ...parts);
  const ply = new PLYExporter().parse(scene, undefined, {});
  console.log(`${name}: PLY ${ply.match(/element vertex (\d+)/)[1]} corners, ${ply.match(/element face (\d+)/)?.[1] ?? "no"} faces`
    + `; STL ${new STLExporter().parse(scene).match(/facet normal/g).length} faces; OBJ ${new OBJExporter().parse(scene).match(/^f /gm).length} faces`);
}
JS
node points.mjs >seen
expect_in seen <<'END'
box: PLY 24 corners, 12 faces; STL 12 faces; OBJ 12 faces
box and point: PLY 25 corners, no faces; STL 12 faces; OBJ 12 faces
END
