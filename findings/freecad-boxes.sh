#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2 on Open CASCADE 7.6.3: the box of a shape (BoundBox), from which scripts take sizes, is that of the control points of its
# surfaces, until something has meshed it, such as its display: then it is that of the facets. A loft 40 mm wide and high is 49.7 x 53.6 x 40
# before, and a torus of 76 mm is 82.3. Believed: to the tolerance of the shape, and the same before and after it is shown.
# For planes, cylinders and cones it is.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
cat >boxes.py <<'PY'
import math
from FreeCAD import Vector
import Part

ring = lambda radius, z: Part.Wire(Part.makeCircle(radius, Vector(0, 0, z)))
turned = lambda shape: shape.rotate(Vector(0, 0, 0), Vector(1, 0, 0), 30) or shape
size = lambda box: " x ".join(f"{length:.1f}" for length in (box.XLength, box.YLength, box.ZLength))
for what, shape in (("cylinder, turned", turned(Part.makeCylinder(10, 40))), ("the same as NURBS", turned(Part.makeCylinder(10, 40)).toNurbs()),
                    ("torus 76 across, turned", turned(Part.makeTorus(30, 8))), ("quarter of a torus", Part.makeTorus(30, 8, Vector(0, 0, 0), Vector(0, 0, 1), -180, 180, 90)),
                    ("loft 40 across", Part.makeLoft([ring(20, 0), ring(5, 20), ring(20, 40)], True)), ("helix 20 across", Part.makeHelix(5, 20, 10))):
    before, best = size(shape.BoundBox), size(shape.optimalBoundingBox(False))
    if shape.Faces:
        shape.tessellate(0.1)
    print(f"{what}: {before}; meshed {size(shape.BoundBox)}; best {best}")
PY
python3 boxes.py >seen
expect_in seen <<'END'
cylinder, turned: 20.0 x 37.3 x 44.6; meshed 20.0 x 37.3 x 44.6; best 20.0 x 37.3 x 44.6
the same as NURBS: 30.0 x 50.0 x 52.0; meshed 20.0 x 37.3 x 44.6; best 20.0 x 37.3 x 44.6
torus 76 across, turned: 82.3 x 72.6 x 48.5; meshed 76.0 x 67.9 x 46.0; best 76.0 x 68.0 x 46.0
quarter of a torus: 41.1 x 41.1 x 16.0; meshed 38.0 x 38.0 x 16.0; best 38.0 x 38.0 x 16.0
loft 40 across: 49.7 x 53.6 x 40.0; meshed 40.0 x 40.0 x 40.0; best 40.0 x 40.0 x 40.0
helix 20 across: 20.5 x 21.0 x 20.0; meshed 20.5 x 21.0 x 20.0; best 20.0 x 20.0 x 20.0
END
