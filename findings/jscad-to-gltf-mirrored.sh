#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# jscad-to-gltf 0.0.5 turns mirrored bodies of JSCAD inside out (JSCAD's own serializers do not), and writes a cube of 10 mm as one of 10 m: the
# unit of glTF is the metre, JSCAD's other serializers write millimetres. What is turned or concave is right. Believed: the same bodies.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages jscad-to-gltf@0.0.5 @jscad/modeling@2.13.0 @jscad/obj-serializer@2.1.23 @jscad/3mf-serializer@2.1.17
cat >write.mjs <<'JS'
import modeling from '@jscad/modeling';
import obj from '@jscad/obj-serializer';
import threemf from '@jscad/3mf-serializer';
import { convertJscadModelToGltf } from 'jscad-to-gltf';

const { extrusions, geometries, primitives, transforms } = modeling;
const volume = (corners) => {
  let sum = 0;
  for (let i = 0; i < corners.length; i += 3) {
    const [a, b, c] = corners.slice(i, i + 3);
    sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  return sum.toFixed(0);
};
const box = transforms.translate([5, 5, 5], primitives.cuboid({ size: [10, 10, 10] }));
const angle = extrusions.extrudeLinear({ height: 10 }, geometries.geom2.fromPoints([[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [0, 20]]));
for (const [name, geom] of Object.entries({ box, turned: transforms.rotateZ(1, box), concave: angle, mirrored: transforms.mirrorX(box), 'mirrored and concave': transforms.mirrorZ(angle) })) {
  const file = JSON.parse((await convertJscadModelToGltf({ geometries: [{ geom }] }, { format: 'gltf' })).data);
  const accessor = file.accessors[file.meshes[0].primitives[0].attributes.POSITION];
  const bytes = Buffer.from(file.buffers[0].uri.split(',')[1], 'base64'), from = file.bufferViews[accessor.bufferView].byteOffset;
  const corners = Array.from({ length: accessor.count }, (_, i) => [0, 4, 8].map((offset) => bytes.readFloatLE(from + 12 * i + offset)));
  const rows = obj.serialize({}, geom)[0].split('\n').map((row) => row.split(' ')), places = rows.filter(([it]) => it === 'v').map(([, ...it]) => it.map(Number));
  console.log(`${name}: volume ${volume(corners)}, in OBJ ${volume(rows.filter(([it]) => it === 'f').flatMap(([, ...it]) => it.map((i) => places[i - 1])))}`);
}
console.log('unit of 3MF: ' + threemf.serialize({ compress: false }, box)[0].match(/unit="(.*?)"/)[1]);
JS
node write.mjs >seen
expect_in seen <<'END'
box: volume 1000, in OBJ 1000
turned: volume 1000, in OBJ 1000
concave: volume 4000, in OBJ 4000
mirrored: volume -1000, in OBJ 1000
mirrored and concave: volume -4000, in OBJ 4000
unit of 3MF: millimeter
END
