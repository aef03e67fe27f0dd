#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# vtk.js 37.4.3 (vtkPLYWriter) writes every face into PLY as though it were a triangle: of a cube of its own (vtkCubeSource), whose faces are quads,
# the corners are mixed up from the second face on, and the last has "undefined" for two of them. Without normals it announces three
# values more for each corner than it writes, so that readers that count them misread all; in binary they cannot notice. It says nothing.
# vtkOBJWriter has the quads. Believed: lists of corners as long as they are, as PLY has them, and properties that have values.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @kitware/vtk.js@37.4.3
cat >write.mjs <<'JS'
globalThis.self = globalThis.window = globalThis;
const load = async (path) => (await import(`@kitware/vtk.js/${path}.js`)).default;
const [Cube, Triangles, Obj, Ply] = await Promise.all(['Filters/Sources/CubeSource', 'Filters/General/TriangleFilter',
  'IO/Misc/OBJWriter', 'IO/Geometry/PLYWriter'].map(load));
const cube = Cube.newInstance({ xLength: 10, yLength: 10, zLength: 10 });
const filter = Triangles.newInstance();
filter.setInputConnection(cube.getOutputPort());
const quads = cube.getOutputData(), triangles = filter.getOutputData();
const written = (Writer, shape, format) => {
  const writer = Writer.newInstance(format ? { format } : {});
  writer.setInputData(shape);
  return writer.getOutputData();
};
for (const [name, shape] of [['quads', quads], ['triangles without normals', triangles]]) {
  const [head, body] = written(Ply, shape, 'ascii').split('end_header\n');
  const values = head.match(/^property float .*$/gm).length, corners = +head.match(/vertex (\d+)/)[1];
  const rows = body.trim().split('\n').map((row) => row.trim());
  console.log(`${name}: ${values} values announced, ${rows[0].split(/\s+/).length} written; faces ${rows.slice(corners, corners + 3).join(', ')}, ..., ${rows.at(-1)}`);
}
const bytes = Buffer.from(written(Ply, triangles, 'binary').buffer), start = bytes.indexOf('end_header') + 11;
const second = [0, 4, 8].map((offset) => bytes.readFloatLE(start + 6 * 4 + offset)).join(' ');
console.log(`binary: second corner, six values of four bytes after the first, ${second}, right ${Array.from(triangles.getPoints().getData().slice(3, 6)).join(' ')}`);
console.log('quads as OBJ: ' + written(Obj, quads).match(/^f .*$/gm).map((row) => row.split(' ').length - 1).join(' '));
JS
node write.mjs >seen
expect_in seen <<'END'
quads: 8 values announced, 8 written; faces 4 0 1 3, 2 4 4 6, 7 5 4 8, ..., 23 22 undefined undefined
triangles without normals: 6 values announced, 3 written; faces 3 0 1 2, 3 3 4 5, 3 6 7 8, ..., 3 33 34 35
binary: second corner, six values of four bytes after the first, -5 -5 -5, right -5 5 5
quads as OBJ: 4 4 4 4 4 4
END
