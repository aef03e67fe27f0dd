#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0: STLExporter and OBJExporter move the corners of a mirrored mesh (scale.x = -1), and keep their order: the body
# in the file is inside out, its volume negative. Believed: the order is turned, as glTF asks of readers.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >mirror.mjs <<'JS'
import { BoxGeometry, Mesh } from 'three';
import { STLExporter } from 'three/examples/jsm/exporters/STLExporter.js';
import { OBJExporter } from 'three/examples/jsm/exporters/OBJExporter.js';
const numbers = match => match.slice(1, 4).map(Number);
const volume = corners => {
  let sum = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = corners.slice(i, i + 3);
    sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  return Math.round(sum * 1e6) / 1e6;
};
for (const x of [1, -1]) {
  const mesh = new Mesh(new BoxGeometry(1, 1, 1));
  mesh.scale.x = x;
  mesh.updateMatrixWorld();
  const stl = [...new STLExporter().parse(mesh).matchAll(/vertex (\S+) (\S+) (\S+)/g)].map(numbers);
  const obj = new OBJExporter().parse(mesh);
  const points = [...obj.matchAll(/^v (\S+) (\S+) (\S+)/gm)].map(numbers);
  const faces = [...obj.matchAll(/^f (\d+)\S* (\d+)\S* (\d+)\S*/gm)].flatMap(face => numbers(face).map(i => points[i - 1]));
  console.log(`scale.x ${x}: STL ${volume(stl)}, OBJ ${volume(faces)}`);
}
JS
node mirror.mjs >seen
expect_in seen <<'END'
scale.x 1: STL 1, OBJ 1
scale.x -1: STL -1, OBJ -1
END
