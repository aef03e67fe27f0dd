#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2: diameters and radii of a TechDraw page written as DXF (writeDXFPage) have both their points in the centre, so that their lines
# have no length and both arrowheads stand in the middle of the hole; a program that measures or redraws them, as after any change, has 0. Lengths are
# right. Nothing is said. Believed: points on the circle (DXF, groups 10 and 15 of DIMENSION).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work QT_QPA_PLATFORM=offscreen
cat >blank.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210"></svg>
SVG
cat >dimensions.py <<'PY'
import math
import FreeCAD, Part, TechDraw
from FreeCAD import Vector

document = FreeCAD.newDocument("d")
part = document.addObject("Part::Feature", "Part")
plate = Part.makeBox(40, 30, 20).cut(Part.makeCylinder(5, 30, Vector(12, 15, -5)))
part.Shape = plate.makeFillet(6, [edge for edge in plate.Edges if edge.BoundBox.ZLength > 1 and edge.BoundBox.XMin > 39])
page, template = document.addObject("TechDraw::DrawPage", "Page"), document.addObject("TechDraw::DrawSVGTemplate", "Template")
template.Template = "blank.svg"
page.Template = template
view = document.addObject("TechDraw::DrawViewPart", "Top")
page.addView(view)
view.Source, view.Direction, view.X, view.Y = [part], Vector(0, 0, 1), 100, 100
document.recompute()
for i, edge in enumerate(view.getVisibleEdges()):
    for kind in ("Diameter", "Radius") if isinstance(edge.Curve, Part.Circle) else ("Distance",):
        dimension = document.addObject("TechDraw::DrawViewDimension", f"{kind}{i}")
        dimension.Type, dimension.References2D, dimension.X, dimension.Y = kind, [(view, f"Edge{i}")], 10, 10
        page.addView(dimension)
document.recompute()
TechDraw.writeDXFPage(page, "page.dxf")
tags = [line.strip() for line in open("page.dxf", errors="replace")]
pairs, things = list(zip(tags[::2], tags[1::2])), []
for code, value in pairs[pairs.index(("2", "ENTITIES")) + 1:]:
    if code == "0":
        things.append({"type": value})
    elif things:
        things[-1][code] = value
for thing in things:
    if thing["type"] == "DIMENSION":
        first, second = {3: ("10", "15"), 4: ("10", "15")}.get(int(thing["70"]) & 7, ("13", "14"))
        ends = [[float(thing[str(int(start) + add)]) for add in (0, 10)] for start in (first, second)]
        print({1: "length", 3: "diameter", 4: "radius"}[int(thing["70"]) & 7], f"said to be {''.join(c for c in thing['1'] if c in '0123456789.')}: points {math.dist(*ends):.0f} apart")
PY
python3 dimensions.py >output 2>messages || { tail -n 3 messages; exit 1; }
grep ' apart' output | sort | uniq -c | sed 's/^ *//' >seen
expect_in seen <<'END'
1 diameter said to be 10: points 0 apart
2 diameter said to be 12: points 0 apart
1 length said to be 18: points 18 apart
1 length said to be 30: points 30 apart
2 length said to be 34: points 34 apart
1 radius said to be 5: points 0 apart
2 radius said to be 6: points 0 apart
END
