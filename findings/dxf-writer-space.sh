#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# dxf-writer 1.18.4 (npm) writes what stands in space elsewhere: a polyline of drawPolyline3d lacks the flag 8 of its group 70 and is a flat one,
# so that its heights are gone; the centre of drawCylinder, a point of the world, is written as one of the object's own axes (ARBITRARY AXIS
# ALGORITHM of the DXF reference), so that a bore along x at (10, 20, 30) stands at (30, 10, 20). Upright cylinders, 3D lines and faces
# are right. Nothing is said. Believed: as ezdxf 0.18.1 reads what it wrote itself.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf-writer@1.18.4
debian_packages python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >write.cjs <<'JS'
const Drawing = require('dxf-writer');
const drawing = new Drawing();
drawing.drawPolyline3d([[0, 0, 0], [10, 0, 5], [10, 10, 15]]);
drawing.drawCylinder(10, 20, 30, 5, 40, 0, 0, 1).drawCylinder(10, 20, 30, 5, 40, 1, 0, 0).drawCylinder(10, 20, 30, 5, 40, 0, 1, 0);
drawing.drawLine3d(0, 0, 0, 10, 0, 5);
require('fs').writeFileSync('written.dxf', drawing.toDxfString());
JS
cat >read.py <<'PY'
import ezdxf
from ezdxf import path

def corner(point):
    return " ".join(f"{value + 0.0:g}" for value in point.round(6))

def told(entity):
    if entity.dxftype() == "CIRCLE":
        return f"cylinder along {corner(entity.dxf.extrusion)}: {corner(entity.ocs().to_wcs(entity.dxf.center))}"
    return f"{entity.dxftype().lower()}: " + ", ".join(corner(point) for point in path.make_path(entity).flattening(1))

own = ezdxf.new("R2000")
own.modelspace().add_polyline3d([(0, 0, 0), (10, 0, 5), (10, 10, 15)])
own.saveas("own.dxf")
for name in ("own.dxf", "written.dxf"):
    for entity in ezdxf.readfile(name).modelspace():
        print(f"{name}: {told(entity)}")
PY
node write.cjs
python3 read.py >seen
expect_in seen <<'END'
own.dxf: polyline: 0 0 0, 10 0 5, 10 10 15
written.dxf: polyline: 0 0 0, 10 0 0, 10 10 0
written.dxf: cylinder along 0 0 1: 10 20 30
written.dxf: cylinder along 1 0 0: 30 10 20
written.dxf: cylinder along 0 1 0: -10 30 20
written.dxf: line: 0 0 0, 10 0 5
END
