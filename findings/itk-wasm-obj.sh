#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# itk-wasm's mesh-io 1.7.1 joins each two numbers of an OBJ's faces to one of 64 bits: what it makes of an OBJ into OBJ or OFF has faces of
# corner 25769803784, of 8 corners. It ends with success. The same box read from OFF or STL is right, and so is what it writes of an OBJ into STL.
# Of an STL of two solids it reads the first. Believed: the faces of the box.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @itk-wasm/mesh-io@1.7.1
{ box_stl a 0; box_stl b 50; } >two.stl
box_stl a 0 >box.stl
python3 - <<'PY'
corners = [(10 * (c & 1), 10 * (c >> 1 & 1), 10 * (c >> 2)) for c in range(8)]
facets = [tuple(map(int, f.split())) for f in "0 2 3,0 3 1,4 5 7,4 7 6,0 1 5,0 5 4,2 6 7,2 7 3,0 4 6,0 6 2,1 3 7,1 7 5".split(",")]
open("box.obj", "w").write("".join("v %d %d %d\n" % c for c in corners) + "".join("f %d %d %d\n" % tuple(i + 1 for i in f) for f in facets))
open("box.off", "w").write("OFF\n8 12 0\n" + "".join("%d %d %d\n" % c for c in corners) + "".join("3 %d %d %d\n" % f for f in facets))
PY
cat >convert.mjs <<'JS'
import { readFileSync } from "node:fs";
import { readMeshNode, writeMeshNode } from "@itk-wasm/mesh-io";
const faces = (name) => {
  const lines = readFileSync(name, "latin1").split("\n").map((line) => line.trim().split(/\s+/));
  if (name.endsWith("stl")) return [lines.filter(([word]) => word === "facet").length, 0];
  const found = name.endsWith("obj") ? lines.filter(([word]) => word === "f") : lines.slice(-13).filter((line) => line.length && line[0] !== "");
  const indices = found.flatMap((line) => line.slice(1).map(Number));
  return [found.filter((line) => line.length === 4).length, Math.max(...indices)];
};
for (const from of ["box.off", "box.stl", "box.obj", "two.stl"]) {
  const mesh = await readMeshNode(from);
  console.log(`${from}: ${mesh.numberOfCells} faces read, numbers as ${mesh.cells.constructor.name}`);
  for (const to of ["out.obj", "out.off", "out.stl"]) {
    await writeMeshNode(mesh, to);
    const [count, last] = faces(to);
    console.log(`${from} into ${to}: ${count} triangles${last ? ", highest corner " + last : ""}`);
  }
}
JS
node convert.mjs >all 2>messages
grep ':' all >seen
expect_in seen <<'END'
box.off: 12 faces read, numbers as Uint32Array
box.off into out.obj: 12 triangles, highest corner 8
box.off into out.off: 12 triangles, highest corner 7
box.off into out.stl: 12 triangles
box.stl: 12 faces read, numbers as Uint32Array
box.stl into out.obj: 12 triangles, highest corner 8
box.stl into out.off: 12 triangles, highest corner 7
box.stl into out.stl: 12 triangles
box.obj: 12 faces read, numbers as BigInt64Array
box.obj into out.obj: 6 triangles, highest corner 25769803784
box.obj into out.off: 6 triangles, highest corner 25769803783
box.obj into out.stl: 12 triangles
two.stl: 12 faces read, numbers as Uint32Array
two.stl into out.obj: 12 triangles, highest corner 8
two.stl into out.off: 12 triangles, highest corner 7
two.stl into out.stl: 12 triangles
END
