#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2's import of OpenSCAD's CSG (importCSG) reads of a polygon with several paths the last one alone: of a plate with two holes it
# makes the second hole, as a body. An extrusion whose scale is 0 vanishes, one whose two scales differ has another volume, and corners
# that an offset is to chamfer stay sharp. Nothing is said. Believed: the volumes of OpenSCAD 2021.01, which follow from the sizes.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1 freecad-common=0.20.2+dfsg1-4+deb12u1 python3-pyside2.qtwidgets=5.15.8-2+b1 python3-six=1.16.0-4 python3-ply=3.11-5
export HOME=$work QT_QPA_PLATFORM=offscreen
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib:$work/root/usr/share/freecad/Ext
PYTHONPATH+=:$work/root/usr/share/freecad/Mod/Draft:$work/root/usr/share/freecad/Mod/OpenSCAD
cat >csg.py <<'PY'
import os
import FreeCAD
import importCSG

EXTRUDE = "linear_extrude(height = {}, center = false, convexity = 1, scale = [{}, {}], $fn = 0, $fa = 12, $fs = 2) {{\n\t{}\n}}\n"
SQUARE = "square(size = [10, 10], center = {});"
PLATE, HOLES = [[0, 0], [20, 0], [20, 10], [0, 10]], [[[x, 3], [x + 4, 3], [x + 4, 7], [x, 7]] for x in (3, 13)]

def polygon(*outlines):
    points = sum(outlines, [])
    paths = [list(range(4 * i, 4 * i + 4)) for i in range(len(outlines))]
    return f"polygon(points = {points}, paths = {paths}, convexity = 1);"

cases = {
    "plate": (EXTRUDE.format(2, 1, 1, polygon(PLATE)), 400),
    "plate with a hole": (EXTRUDE.format(2, 1, 1, polygon(PLATE, HOLES[0])), 368),
    "plate with two holes": (EXTRUDE.format(2, 1, 1, polygon(PLATE, *HOLES)), 336),
    "two squares": (EXTRUDE.format(2, 1, 1, polygon(*HOLES)), 64),
    "square, half as large at its end": (EXTRUDE.format(10, 0.5, 0.5, SQUARE.format("true")), 10 / 3 * (100 + 50 + 25)),
    "square, a point at its end": (EXTRUDE.format(10, 0, 0, SQUARE.format("true")), 1000 / 3),
    "square, 20 x 5 at its end": (EXTRUDE.format(10, 2, 0.5, SQUARE.format("true")), 10 / 6 * (100 + 4 * 15 * 7.5 + 100)),
    "square with chamfers around": (EXTRUDE.format(1, 1, 1, "offset(delta = 1, chamfer = true, $fn = 0, $fa = 12, $fs = 2) {\n\t\t" + SQUARE.format("false") + "\n\t}"), 140 + 4 * (1 - (2 - 2 ** 0.5) ** 2 / 2)),
}
for what, (text, right) in cases.items():
    with open("part.csg", "w") as file:
        file.write(text)
    importCSG.open(os.path.abspath("part.csg"))
    document = FreeCAD.ActiveDocument
    document.recompute()
    ends = [thing.Shape for thing in document.Objects if hasattr(thing, "Shape") and not thing.InList and not thing.Shape.isNull()]
    print(f"volume of {what}: {sum(shape.Volume for shape in ends):.1f}, right would be {right:.1f}")
    FreeCAD.closeDocument(document.Name)
PY
python3 csg.py >output 2>messages || { tail -n 3 messages; exit 1; }
grep ^volume output >seen
expect_in seen <<'END'
volume of plate: 400.0, right would be 400.0
volume of plate with a hole: 32.0, right would be 368.0
volume of plate with two holes: 32.0, right would be 336.0
volume of two squares: 32.0, right would be 64.0
volume of square, half as large at its end: 583.3, right would be 583.3
volume of square, a point at its end: 0.0, right would be 333.3
volume of square, 20 x 5 at its end: 1024.0, right would be 1083.3
volume of square with chamfers around: 144.0, right would be 143.3
END
