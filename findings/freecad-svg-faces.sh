#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2's export to SVG (importSVG, by Draft) writes of a flat face that has a round border or hole that one circle alone: of a
# washer a disc, of a plate with two holes one of the holes and no plate. A face with a square hole is whole. Nothing is said. Believed:
# all borders of the face, which a laser cutter is to follow.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1 freecad-common=0.20.2+dfsg1-4+deb12u1 python3-pyside2.qtwidgets=5.15.8-2+b1 python3-pyside2.qtsvg=5.15.8-2+b1 python3-six=1.16.0-4
export HOME=$work QT_QPA_PLATFORM=offscreen
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib:$work/root/usr/share/freecad/Ext:$work/root/usr/share/freecad/Mod/Draft
cat >faces.py <<'PY'
import re
import FreeCAD
from FreeCAD import Vector
import importSVG, Part

circle = lambda radius, x=0: Part.Wire(Part.makeCircle(radius, Vector(x, 0, 0)))
square = lambda side: Part.makePolygon([Vector(x * side / 2, y * side / 2, 0) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))])
for what, wires in {"square plate with a square hole": [square(40), square(10)], "square plate with a round hole": [square(40), circle(5)],
                    "square plate with two round holes": [square(40), circle(5, -10), circle(3, 10)], "disc": [circle(10)], "washer": [circle(10), circle(5)],
                    "disc with three holes": [circle(10), circle(1, -5), circle(1), circle(1, 5)]}.items():
    document = FreeCAD.newDocument("sheet")
    thing = document.addObject("Part::Feature", "Face")
    thing.Shape = Part.makeFace(Part.makeCompound(wires), "Part::FaceMakerBullseye")
    document.recompute()
    importSVG.export([thing], "face.svg")
    drawing = open("face.svg").read()
    radii, paths = re.findall(' r="([^"]*)"', drawing), re.findall(' d="([^"]*)"', drawing)
    print(f"{what} ({len(wires)} borders): {sum(path.count('M') for path in paths)} polygons, {len(radii)} circles", *(f"of radius {radius}" for radius in radii))
    FreeCAD.closeDocument(document.Name)
PY
python3 faces.py >output 2>messages || { tail -n 3 messages; exit 1; }
grep ' borders' output >seen
expect_in seen <<'END'
square plate with a square hole (2 borders): 2 polygons, 0 circles
square plate with a round hole (2 borders): 0 polygons, 1 circles of radius 5.0
square plate with two round holes (3 borders): 0 polygons, 1 circles of radius 5.0
disc (1 borders): 0 polygons, 1 circles of radius 10.0
washer (2 borders): 0 polygons, 1 circles of radius 10.0
disc with three holes (4 borders): 0 polygons, 1 circles of radius 10.0
END
