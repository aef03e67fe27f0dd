#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: VRMLLoader takes of a VRML97 Transform its translation, rotation and scale, and ignores center and scaleOrientation: a
# part that turns about (10, 0, 0), such as a hinge, is drawn 20 away. What stands in a Switch (a chosen variant) or an LOD is not
# drawn. Believed: as ISO 14772 defines them, T C R SR S -SR -C.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >places.mjs <<'JS'
import { Box3 } from 'three';
import { VRMLLoader } from 'three/examples/jsm/loaders/VRMLLoader.js';
const shape = 'Shape { geometry Box { size 2 2 2 } }';
const half = 'rotation 0 0 1 3.14159265';
const programs = {
  'turned about the origin': `Transform { ${half} children ${shape} }`,
  'turned about (10, 0, 0)': `Transform { ${half} center 10 0 0 children ${shape} }`,
  'scaled about (1, 0, 0)': `Transform { scale 3 1 1 center 1 0 0 children ${shape} }`,
  'scaled along y': `Transform { scale 3 1 1 scaleOrientation 0 0 1 1.57079633 children ${shape} }`,
  'chosen': `Switch { whichChoice 0 choice [ ${shape} ] }`,
  'level of detail': `LOD { range [ 100 ] level [ ${shape} ${shape} ] }`,
};
for (const [name, text] of Object.entries(programs)) {
  const box = new Box3().setFromObject(new VRMLLoader().parse('#VRML V2.0 utf8\n' + text));
  const side = axis => `${axis} ${Math.round(box.min[axis])} to ${Math.round(box.max[axis])}`;
  console.log(`${name}: ${box.isEmpty() ? 'nothing' : side('x') + ', ' + side('y')}`);
}
JS
node places.mjs 2>&1 | tee all | grep -v '^THREE' >seen || true
expect_in seen <<'END'
turned about the origin: x -1 to 1, y -1 to 1
turned about (10, 0, 0): x -1 to 1, y -1 to 1
scaled about (1, 0, 0): x -3 to 3, y -1 to 1
scaled along y: x -3 to 3, y -1 to 1
chosen: nothing
level of detail: nothing
END
