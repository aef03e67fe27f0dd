#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3's exact hidden-line removal (HLRBRep, here by FreeCAD 0.20.2's TechDraw, which draws by it) gives edges that are ellipses or
# hyperbolas as 14 straight pieces, whatever their size, unless they lie in the plane of the paper: the end of a cylinder of radius 100 cut off
# askew is a polygon 2.5 mm inside of its outline as seen along its axis, and that of radius 1000 one of 25 mm. Circles and
# splines stay curves. Believed: curves, or pieces as many as the size needs.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
cat >chords.py <<'PY'
import math
from FreeCAD import Vector
import Part, TechDraw

def bar(radius, lean):
    """A cylinder along z, its upper end turned by the lean in degrees."""
    above = Part.makeBox(9 * radius, 9 * radius, 9 * radius, Vector(-4.5 * radius, -4.5 * radius, 0))
    above.rotate(Vector(0, 0, 0), Vector(0, 1, 0), lean)
    return Part.makeCylinder(radius, 4 * radius, Vector(0, 0, -2 * radius)).cut(above)

for radius, lean in ((10, 0), (10, 30), (100, 0), (100, 30), (1000, 30)):
    visible = TechDraw.project(bar(radius, lean), Vector(0, 0, 1))[0]
    for edge in visible.Edges:
        first, last = edge.ParameterRange
        distances = [edge.valueAt(first + (last - first) * k / 1400).Length for k in range(1401)]
        curve = edge.Curve
        print(f"radius {radius}, end at {lean} degrees: {type(curve).__name__}", *(("of degree", curve.Degree, "with", curve.NbPoles, "points") if hasattr(curve, "Degree") else ()),
              f"at {min(distances):.2f} to {max(distances):.2f}")
cone = Part.makeCone(100, 0, 200).cut(Part.makeBox(400, 400, 400, Vector(50, -200, -100)))
for edge in TechDraw.project(cone, Vector(1, 0, 0))[0].Edges:
    if edge.Length > 100 and hasattr(edge.Curve, "Degree"):
        print(f"hyperbola {edge.Length:.0f} long: of degree", edge.Curve.Degree, "with", edge.Curve.NbPoles, "points")
PY
python3 chords.py >seen
expect_in seen <<'END'
radius 10, end at 0 degrees: Circle at 10.00 to 10.00
radius 10, end at 30 degrees: BSplineCurve of degree 1 with 15 points at 9.75 to 10.00
radius 100, end at 0 degrees: Circle at 100.00 to 100.00
radius 100, end at 30 degrees: BSplineCurve of degree 1 with 15 points at 97.49 to 100.00
radius 1000, end at 30 degrees: BSplineCurve of degree 1 with 15 points at 974.93 to 1000.00
hyperbola 136 long: of degree 1 with 15 points
hyperbola 136 long: of degree 1 with 15 points
END
