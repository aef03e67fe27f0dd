#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# assimp 5.2.5 writes STEP whose unit is named METRE and is one millimetre: a glTF box of 10 mm comes out 0.01 mm wide. Of a mesh shown by
# two nodes it writes one. All faces look inwards. Open CASCADE reads the file. Believed: 10 mm, two boxes, outwards; glTF 2.0 (3.4) is in metres,
# and ISO 10303-41 measures in the unit's conversion factor.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1 libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
gltf one.gltf '{"mesh": 0}'
gltf two.gltf '{"mesh": 0, "translation": [0.02, 0, 0]}' '{"mesh": 0, "translation": [0.05, 0, 0]}'
assimp export one.gltf one.stp >/dev/null
assimp export two.gltf two.stp >/dev/null
cat >read.py <<'PY'
import FreeCAD, Part
for name in ("one", "two"):
    text = open(name + ".stp").read()
    shape = Part.Shape()
    shape.read(name + ".stp")
    box = shape.BoundBox
    print(f"{name}: {len(shape.Faces)} faces, x = {abs(box.XMin):.2f} to {box.XMax:.2f} mm, volume {shape.Volume * 1e6:.2f}e-6 mm3;", "METRE is",
          *{unit for unit in ("SI_UNIT(.MILLI.,.METRE.)", "SI_UNIT($,.METRE.)") if unit in text})
PY
python3 read.py >output 2>messages || { cat messages >&2; exit 1; }
grep -E '^(one|two)' output >seen
expect_in seen <<'END'
one: 12 faces, x = 0.00 to 0.01 mm, volume -1.00e-6 mm3; METRE is SI_UNIT(.MILLI.,.METRE.)
two: 12 faces, x = 0.02 to 0.03 mm, volume -1.00e-6 mm3; METRE is SI_UNIT(.MILLI.,.METRE.)
END
