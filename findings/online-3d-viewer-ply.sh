#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# online-3d-viewer 0.18.0 (3dviewer.net) takes the first three properties of a vertex of a PLY for its place, whatever their names are: a box
# whose file has the normals or the colours first becomes a point. In ASCII it takes edges that stand before the faces for faces. Of
# float64, the other name of double (as in rply), it says that there are no meshes. Believed: places are x, y and z, and elements come in the
# order of the header.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages online-3d-viewer@0.18.0
cat >write.py <<'PY'
import struct
corners = [[10 * (i >> axis & 1) for axis in range(3)] for i in range(8)]
faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
place = [f"float {axis}" for axis in "xyz"]

def write(name, properties, row, edges=0):
    binary = isinstance(row(corners[0]), bytes)
    head = ["ply", f"format {'binary_little_endian' if binary else 'ascii'} 1.0", "element vertex 8", *("property " + it for it in properties)]
    if edges:
        head += [f"element edge {edges}", *(f"property {it}" for it in ("int vertex1", "int vertex2", "uchar red", "uchar green", "uchar blue"))]
    head += ["element face 6", "property list uchar int vertex_indices", "end_header"]
    with open(name + ".ply", "wb") as file:
        file.write("\n".join(head).encode() + b"\n")
        for corner in corners:
            file.write(row(corner) if binary else (row(corner) + "\n").encode())
        for i in range(edges):
            file.write(f"{i} {i + 1} 3 3 3\n".encode())
        for face in faces:
            file.write(struct.pack("<B4i", 4, *face) if binary else (" ".join(map(str, [4, *face])) + "\n").encode())

write("place", place, lambda c: "%d %d %d" % tuple(c))
write("place and normal", place + [f"float n{axis}" for axis in "xyz"], lambda c: "%d %d %d 0 0 1" % tuple(c))
write("normal and place", [f"float n{axis}" for axis in "xyz"] + place, lambda c: "0 0 1 %d %d %d" % tuple(c))
write("colour and place, binary", ["uchar red", "uchar green", "uchar blue"] + place, lambda c: struct.pack("<3B3f", 1, 2, 3, *c))
write("place of double, binary", [f"double {axis}" for axis in "xyz"], lambda c: struct.pack("<3d", *c))
write("place of float64, binary", [f"float64 {axis}" for axis in "xyz"], lambda c: struct.pack("<3d", *c))
write("edges before the faces", place, lambda c: "%d %d %d" % tuple(c), edges=3)
PY
cat >read.mjs <<'JS'
import { readFileSync } from 'node:fs';
import { CalculateVolume, GetBoundingBox, ImporterPly } from 'online-3d-viewer';

for (const name of ['place', 'place and normal', 'normal and place', 'colour and place, binary', 'place of double, binary', 'place of float64, binary', 'edges before the faces']) {
  const importer = new ImporterPly(), bytes = new Uint8Array(readFileSync(name + '.ply'));
  importer.Import(name, 'ply', bytes.buffer, {
    getDefaultLineMaterialColor() {}, getDefaultMaterialColor() {}, onComplete() {},
    onError: () => console.log(`${name}: ${importer.GetErrorMessage()}`),
    onSuccess: () => {
      const { min, max } = GetBoundingBox(importer.GetModel()), volume = CalculateVolume(importer.GetModel());
      console.log(`${name}: ${['x', 'y', 'z'].map((axis) => `${min[axis]}..${max[axis]}`).join(' ')}, volume ${volume === null ? 'of no closed body' : volume.toFixed(0)}`);
    },
  });
}
JS
python3 write.py
node read.mjs >seen
expect_in seen <<'END'
place: 0..10 0..10 0..10, volume 1000
place and normal: 0..10 0..10 0..10, volume 1000
normal and place: 0..0 0..0 1..1, volume 0
colour and place, binary: 1..1 2..2 3..3, volume 0
place of double, binary: 0..10 0..10 0..10, volume 1000
place of float64, binary: The model doesn't contain any meshes.
edges before the faces: 0..10 0..10 0..10, volume 333
END
