#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Babylon.js 9.28.0 (STLExport.CreateSTL) puts the place in the world into the corners of each mesh that it writes, and leaves the node above
# where it is: after each export a part below a placed node stands further off in the scene, and in the next file. OBJExport, which does
# the same, takes it back. The page says that transforms are baked, not that the scene moves. Believed: writing a file changes nothing, and
# two files of one scene are equal. With the parameter doNotBakeTransform the part lies at the origin.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @babylonjs/core@9.28.0 @babylonjs/serializers@9.28.0
cat >export.cjs <<'JS'
const { MeshBuilder, NullEngine, Scene, TransformNode } = require('@babylonjs/core');
const { OBJExport, STLExport } = require('@babylonjs/serializers');
const scene = new Scene(new NullEngine());
const placed = () => {
  const above = new TransformNode('assembly', scene), part = MeshBuilder.CreateBox('part', { size: 10 }, scene);
  part.parent = above;
  above.position.x = 100;
  return part;
};
const range = (numbers) => `${Math.min(...numbers)} to ${Math.max(...numbers)}`;
const inScene = (part) => {
  part.computeWorldMatrix(true);
  const box = part.getBoundingInfo().boundingBox;
  return range([box.minimumWorld.x, box.maximumWorld.x]);
};
const inFile = (text, word) => range([...text.matchAll(new RegExp(`^\\s*${word} (\\S+)`, 'gm'))].map((found) => Math.abs(found[1])));
const stl = placed(), obj = placed();
console.log(`STL: scene ${inScene(stl)} before`);
for (let i = 0; i < 2; ++i) console.log(`STL: file ${inFile(STLExport.CreateSTL([stl], false, '', false, false), 'vertex')}, scene ${inScene(stl)}`);
for (let i = 0; i < 2; ++i) console.log(`OBJ: file ${inFile(OBJExport.OBJ([obj], false, '', true), 'v')}, scene ${inScene(obj)}`);
JS
node export.cjs | grep : | grep -v BJS >seen
expect_in seen <<'END'
STL: scene 95 to 105 before
STL: file 95 to 105, scene 195 to 205
STL: file 195 to 205, scene 295 to 305
OBJ: file 95 to 105, scene 95 to 105
OBJ: file 95 to 105, scene 95 to 105
END
