#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gltfpack 1.3.0 joins the parts of an assembly that have one material into one mesh and then gives that 14 bits for its whole length:
# in an assembly of 10 m, parts of 10 to 15 mm come out some tenths of a millimetre too short or too long, a little elsewhere, and most
# names are gone. A part alone keeps its size. glTF-Transform 4.5.1 does the same by join and quantize. The help names 14 bits, not of what.
# Believed: of each part.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages gltfpack@1.3.0 @gltf-transform/core@4.5.1 @gltf-transform/extensions@4.5.1 @gltf-transform/functions@4.5.1
cat >write.mjs <<'JS'
import { Document, NodeIO } from '@gltf-transform/core';
const tenths = [[0, 10], [25003, 10], [50007, 12], [75011, 14], [100014, 15]];  // begin and length of five parts, 0.1 mm
for (const [file, parts] of [['assembly', tenths], ['part', [[0, 10]]]]) {
  const document = new Document(), buffer = document.createBuffer(), scene = document.createScene();
  parts.forEach(([begin, length], part) => {
    const corners = [...'01234567'].flatMap(i => [(i & 1) * length * 0.001, ((i >> 1) & 1) * 0.02, (i >> 2) * 0.007]);
    const facets = [0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5];
    const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
    const primitive = document.createPrimitive().setAttribute('POSITION', accessor('VEC3', new Float32Array(corners)))
      .setIndices(accessor('SCALAR', new Uint16Array(facets)));
    scene.addChild(document.createNode(`part ${part}`).setMesh(document.createMesh().addPrimitive(primitive)).setTranslation([begin * 1e-4, 0, 0]));
  });
  await new NodeIO().write(file + '.glb', document);
}
JS
cat >read.mjs <<'JS'
import { NodeIO } from '@gltf-transform/core';
import { KHRONOS_EXTENSIONS } from '@gltf-transform/extensions';
import { flatten, join, quantize } from '@gltf-transform/functions';
const io = new NodeIO().registerExtensions(KHRONOS_EXTENSIONS);
const report = (name, document) => {
  const ends = new Set();
  let names = 0;
  document.getRoot().listScenes()[0].traverse(node => {
    names += node.getName().startsWith('part');
    const m = node.getWorldMatrix();
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const positions = primitive.getAttribute('POSITION');
      for (let i = 0; i < positions.getCount(); ++i) {
        const [x, y, z] = positions.getElement(i, []);
        ends.add((1000 * (m[0] * x + m[4] * y + m[8] * z + m[12])).toFixed(2));
      }
    }
  });
  const sorted = [...ends].map(Number).sort((a, b) => a - b);
  const lengths = sorted.flatMap((x, i) => (i % 2 ? [(x - sorted[i - 1]).toFixed(2)] : []));
  console.log(`${name}: ${lengths.join(', ')} mm long, the last from ${sorted.at(-2).toFixed(2)}, ${names} names`);
};
report('as written', await io.read('assembly.glb'));
report('gltfpack', await io.read('packed.glb'));
const joined = await io.read('assembly.glb');
joined.setLogger({ debug() {}, info() {}, warn() {}, error() {} });
await joined.transform(flatten(), join(), quantize());
report('join and quantize', joined);
report('gltfpack, one part', await io.read('packed-part.glb'));
JS
node write.mjs
npx gltfpack -i assembly.glb -o packed.glb >/dev/null
npx gltfpack -i part.glb -o packed-part.glb >/dev/null
node read.mjs >seen
expect_in seen <<'END'
as written: 10.00, 10.00, 12.00, 14.00, 15.00 mm long, the last from 10001.40, 5 names
gltfpack: 9.78, 9.78, 12.23, 14.06, 15.28 mm long, the last from 10001.12, 2 names
join and quantize: 9.78, 10.55, 11.62, 14.22, 15.28 mm long, the last from 10001.12, 1 names
gltfpack, one part: 10.00 mm long, the last from 0.00, 0 names
END
