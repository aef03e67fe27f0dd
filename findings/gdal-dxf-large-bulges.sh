#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# GDAL 3.6.2 (ogr2ogr, and with it QGIS) reads an arc of a DXF polyline that is larger than a half circle, bulge > 1, as a small one on
# the other side of its chord; clockwise (bulge < -1) it is right. Believed: all within the step of 4 degrees. ezdxf has them all right.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages gdal-bin=3.6.2+dfsg-1+b2 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
export PROJ_DATA=$work/root/usr/share/proj GDAL_DATA=$work/root/usr/share/gdal
cat >bulges.py <<'PY'
import json, math, subprocess
import ezdxf
from ezdxf import path

def described(points):
    length = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
    low, high = (round(limit(p[1] for p in points), 1) + 0.0 for limit in (min, max))
    return f"y {low} to {high}, {length:.1f} long"

for bulge in (0.9, 1.1, 2, -2):
    drawing = ezdxf.new("R2000")
    polyline = drawing.modelspace().add_lwpolyline([(0, 0, bulge), (10, 0, 0)], format="xyb")
    drawing.saveas("arc.dxf")
    exact = [(p.x, p.y) for p in path.make_path(polyline).flattening(0.0001)]
    subprocess.run(["ogr2ogr", "-f", "GeoJSON", "/vsistdout/", "arc.dxf"], stdout=open("arc.json", "wb"), check=True)
    read = json.load(open("arc.json"))["features"][0]["geometry"]["coordinates"]
    print(f"bulge {bulge}: {described(exact)}; GDAL {described(read)}")
PY
python3 bulges.py >seen
expect_in seen <<'END'
bulge 0.9: y -4.5 to 0.0, 14.7 long; GDAL y -4.5 to 0.0, 14.7 long
bulge 1.1: y -5.5 to 0.0, 16.7 long; GDAL y 0.0 to 4.5, 14.8 long
bulge 2: y -10.0 to 0.0, 27.7 long; GDAL y 0.0 to 2.5, 11.6 long
bulge -2: y 0.0 to 10.0, 27.7 long; GDAL y 0.0 to 10.0, 27.7 long
END
