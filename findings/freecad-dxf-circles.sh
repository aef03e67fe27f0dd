#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2 writes shapes into DXF (Import.writeDXFShape, writeDXFObject, its usual exporter) with every circle and arc in the plane of the paper, at the height
# 0 for circles: of a plate with a bore from front to back the circles lie flat on the floor, and an arc in such a plane has no length. Numbers
# have six digits: 10.4 mm at 123 m from the origin become 11. Lines and splines are in space, where they were. Nothing is
# said. Believed: circles in their planes, by group 210 to 230, or as curves.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
cat >circles.py <<'PY'
from FreeCAD import Vector
import Import, Part

front, top = Vector(0, 1, 0), Vector(0, 0, 1)
shapes = {"circle seen from the front, centre 20 0 10": Part.makeCircle(5, Vector(20, 0, 10), front),
          "circle seen from the top, centre 20 0 10": Part.makeCircle(5, Vector(20, 0, 10), top),
          "quarter seen from the front, centre 20 0 10": Part.makeCircle(5, Vector(20, 0, 10), front, 0, 90),
          "quarter seen from the top, centre 20 0 10": Part.makeCircle(5, Vector(20, 0, 10), top, 0, 90),
          "line from 20 0 10 to 20 0 15": Part.makeLine(Vector(20, 0, 10), Vector(20, 0, 15)),
          "line from 123456.3 0 0 to 123466.7 0 0": Part.makeLine(Vector(123456.3, 0, 0), Vector(123466.7, 0, 0))}
for what, shape in shapes.items():
    Import.writeDXFShape([shape], "shape.dxf")
    tags = [line.strip() for line in open("shape.dxf")]
    pairs = list(zip(tags[::2], tags[1::2]))
    pairs = pairs[pairs.index(("2", "ENTITIES")) + 1:]
    values = {code: value for code, value in reversed(pairs[1:pairs.index(("0", "ENDSEC"))])}
    groups = {"at": ("10", "20", "30"), "to": ("11", "21", "31"), "radius": ("40",), "angles": ("50", "51"), "direction": ("210", "220", "230")}
    print(what + ":", pairs[0][1], *(name + "".join(" " + values.get(code, "?") for code in codes) for name, codes in groups.items() if codes[0] in values))
PY
python3 circles.py >seen
expect_in seen <<'END'
circle seen from the front, centre 20 0 10: CIRCLE at 20 0 ? radius 5
circle seen from the top, centre 20 0 10: CIRCLE at 20 0 ? radius 5
quarter seen from the front, centre 20 0 10: ARC at 20 0 10 radius 5 angles 0 0
quarter seen from the top, centre 20 0 10: ARC at 20 0 10 radius 5 angles 0 90
line from 20 0 10 to 20 0 15: LINE at 20 0 10 to 20 0 15
line from 123456.3 0 0 to 123466.7 0 0: LINE at 123456 0 0 to 123467 0 0
END
