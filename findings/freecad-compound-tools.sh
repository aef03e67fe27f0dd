#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2 on Open CASCADE 7.6.3: a compound whose bodies overlap or touch, as arrays and groups often do, cuts nothing, adds one body of two,
# or has nothing in common; bores one above the other leave two discs across the hole. The results are called valid. Given as a list
# of the same bodies all are right. Believed: a compound is the union of its bodies, or refused; the manual asks for bodies that do not interfere.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
cat >tools.py <<'PY'
from FreeCAD import Vector
import Part

block = lambda x, y, z, height: Part.makeBox(10, 10, height, Vector(x, y, z))
crossing = [block(5, 5, -5, 30), block(10, 10, -5, 30)]
beside = [block(0, 0, 20, 10), block(10, 0, 20, 10)]
bores = [Part.makeCylinder(5, 10, Vector(20, 15, z)) for z in (0, 10)]
plate = Part.makeBox(40, 30, 20)
for what, work, tools in (("cut by two that cross", plate.cut, crossing), ("common with two that cross", plate.common, crossing),
                          ("fused with two that touch", plate.fuse, beside), ("cut by two bores in a row", plate.cut, bores)):
    for way, tool in (("list", tools), ("compound", Part.makeCompound(tools))):
        body = work(tool)
        print(f"{what}, as a {way}: {body.Volume:.0f} mm3, {len(body.removeSplitter().Faces)} faces, {'' if body.isValid() else 'not '}valid")
PY
python3 tools.py >seen
expect_in seen <<'END'
cut by two that cross, as a list: 20500 mm3, 14 faces, valid
cut by two that cross, as a compound: 24000 mm3, 18 faces, valid
common with two that cross, as a list: 3500 mm3, 18 faces, valid
common with two that cross, as a compound: 0 mm3, 0 faces, valid
fused with two that touch, as a list: 26000 mm3, 9 faces, valid
fused with two that touch, as a compound: 25000 mm3, 9 faces, valid
cut by two bores in a row, as a list: 22429 mm3, 7 faces, valid
cut by two bores in a row, as a compound: 22429 mm3, 10 faces, valid
END
