#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three.js 0.187.0 (VTKLoader, until its release 194) takes the doubles of a binary VTK file for floats: a box becomes points elsewhere. Of faces that stand
# on one line of an ASCII file, which VTK's format allows, it reads the first, and a file of less than 250 bytes, such as one of a
# triangle, raises an error. Faces of four corners and strips are right. Believed: the same box each time.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0
cat >read.mjs <<'JS'
import { Box3 } from 'three';
import { VTKLoader } from 'three/examples/jsm/loaders/VTKLoader.js';

const places = Array.from({ length: 8 }, (_, i) => [10 * (i & 1), 10 * (i >> 1 & 1), 10 * (i >> 2)]);
const faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
const bytes = (values, size, write) => {
  const buffer = Buffer.alloc(size * values.length);
  values.forEach((value, i) => buffer[write](value, size * i));
  return buffer;
};
const head = (kind) => `# vtk DataFile Version 3.0\nA box whose sides are 10 long, and of which each of the six faces has four corners\n${kind}\nDATASET POLYDATA\n`;
const ascii = (rows, end) => head('ASCII') + `POINTS 8 float\n${places.map((it) => it.join(' ')).join('\n')}\n${rows} 6 30\n${faces.map(([a, b, c, d]) => (rows === 'POLYGONS' ? [4, a, b, c, d] : [4, a, b, d, c]).join(' ')).join(end)}\n`;
const binary = (type, size, write) => Buffer.concat([Buffer.from(`${head('BINARY')}POINTS 8 ${type}\n`), bytes(places.flat(), size, write),
  Buffer.from('\nPOLYGONS 6 30\n'), bytes(faces.flatMap((it) => [4, ...it]), 4, 'writeInt32BE'), Buffer.from('\n')]);
for (const [name, file] of Object.entries({
  'faces': ascii('POLYGONS', '\n'), 'strips': ascii('TRIANGLE_STRIPS', '\n'), 'faces on one line': ascii('POLYGONS', ' '),
  'binary floats': binary('float', 4, 'writeFloatBE'), 'binary doubles': binary('double', 8, 'writeDoubleBE'),
  'one triangle': '# vtk DataFile Version 3.0\nA triangle\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0\n10 0 0\n0 10 0\nPOLYGONS 1 4\n3 0 1 2\n',
})) try {
  const shape = new VTKLoader().parse(new Uint8Array(Buffer.from(file)).buffer), { min, max } = new Box3().setFromBufferAttribute(shape.attributes.position);
  console.log(`${name}: ${(shape.index ?? shape.attributes.position).count / 3} triangles, ${['x', 'y', 'z'].map((axis) => `${+min[axis].toPrecision(3)}..${+max[axis].toPrecision(3)}`).join(' ')}`);
} catch (error) {
  console.log(`${name}: ${error.constructor.name}`);
}
JS
node read.mjs 2>messages >seen
expect_in seen <<'END'
faces: 12 triangles, 0..10 0..10 0..10
strips: 12 triangles, 0..10 0..10 0..10
faces on one line: 2 triangles, 0..10 0..10 0..10
binary floats: 12 triangles, 0..10 0..10 0..10
binary doubles: 12 triangles, 0..2.56 0..0 0..2.56
one triangle: RangeError
END
