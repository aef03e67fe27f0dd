#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# assimp 5.2.5 writes a glTF of one tetrahedron at three places into 3MF as three tetrahedra at one place, a thousandth of their size:
# metres become millimetres. Its OBJ of the same file has them where they are. Believed: nodes have places.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1
python3 - <<'PY'
import base64, json, struct
points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
faces = [0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]
data = b"".join(struct.pack("<3f", *p) for p in points) + struct.pack("<12H", *faces)
places = [{"mesh": 0}, {"mesh": 0, "translation": [5, 0, 0]}, {"mesh": 0, "translation": [10, 0, 0]}]
json.dump({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}], "nodes": places,
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
    "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 1]},
                  {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}]}, open("three.gltf", "w"))
PY
assimp export three.gltf three.3mf >/dev/null
assimp export three.gltf three.obj >/dev/null
python3 - >seen <<'PY'
import re, zipfile
text = zipfile.ZipFile("three.3mf").read("3D/3DModel.model").decode()
xs = [float(x) for x in re.findall(r'<vertex x="([^"]*)"', text)]
print(f"3MF in {re.search('unit=.([a-z]*)', text)[1]}: {len(re.findall('<item ', text))} items, "
      f"{len(re.findall('<item [^>]*transform', text))} with a place, x from {min(xs):g} to {max(xs):g}")
xs = [float(line.split()[1]) for line in open("three.obj") if line.startswith("v ")]
print(f"OBJ: x from {min(xs):g} to {max(xs):g}")
PY
expect_in seen <<'END'
3MF in millimeter: 3 items, 0 with a place, x from 0 to 1
OBJ: x from 0 to 11
END
