#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: OBJLoader cuts every face into a fan from its first corner. Of an L of area 3, given as one face, the triangles
# cover 4: one of them turns back and lies outside of the L. Believed: faces of OBJ, which may be concave, are triangulated.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >face.mjs <<'JS'
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js';
const text = 'v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 3 4 5 6 1 2\n';
const p = new OBJLoader().parse(text).children[0].geometry.attributes.position;
let covered = 0, turned = 0;
for (let i = 0; i < p.count; i += 3) {
  const area = ((p.getX(i + 1) - p.getX(i)) * (p.getY(i + 2) - p.getY(i)) -
                (p.getY(i + 1) - p.getY(i)) * (p.getX(i + 2) - p.getX(i))) / 2;
  covered += Math.abs(area);
  turned += area < 0;
}
console.log(`triangles cover ${covered}, ${turned} turned`);
JS
node face.mjs >seen
expect_in seen <<'END'
triangles cover 4, 1 turned
END
