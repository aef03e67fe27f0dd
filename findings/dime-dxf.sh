#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# dime 0.20111205 (DXF for Coin and Open Inventor) makes of a DXF, by dxf2vrml, ellipses of half their size: one of 40 x 20 mm becomes 20 x 10. Arcs of
# LWPOLYLINE become their chords, so that a circle of two arcs is a line, and so does the arc that closes a POLYLINE; splines are left out. It says
# nothing, and ends with success. Circles, and turned, scaled and arrayed blocks, are right. Believed: each as large as it is in DXF.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages dime=0.20111205-2.1
draw() {  # NAME ENTITIES
  printf '%s\n' 0 SECTION 2 HEADER 9 '$ACADVER' 1 AC1015 0 ENDSEC 0 SECTION 2 ENTITIES $2 0 ENDSEC 0 EOF >part.dxf
  dxf2vrml part.dxf >part.wrl
  python3 - "$1" <<'PY'
import re, sys
points = re.search(r"point \[([^]]*)\]", open("part.wrl").read())
corners = [tuple(map(float, point.split())) for point in points[1].split(",") if point.strip()] if points else []
print(f"{sys.argv[1]}:", " x ".join(f"{max(axis) - min(axis):.0f}" for axis in list(zip(*corners))[:2]) or "nothing")
PY
}
ellipse='0 ELLIPSE 5 A1 100 AcDbEntity 8 0 100 AcDbEllipse 10 50 20 20 30 0 210 0 220 0 230 1 41 0 42 6.283185307179586'
{
  draw 'ellipse of 40 x 20' "$ellipse 11 20 21 0 31 0 40 0.5"
  draw 'upright ellipse of 20 x 40' "$ellipse 11 0 21 20 31 0 40 0.5"
  draw 'circle of 40' '0 CIRCLE 5 A1 100 AcDbEntity 8 0 100 AcDbCircle 10 50 20 20 30 0 40 20'
  draw 'LWPOLYLINE of two half circles, 40 x 40' '0 LWPOLYLINE 5 A1 100 AcDbEntity 8 0 100 AcDbPolyline 90 2 70 1 10 0 20 0 42 1 10 40 20 0 42 1'
  draw 'POLYLINE of two half circles, 40 x 40' \
    '0 POLYLINE 8 0 66 1 70 1 10 0 20 0 30 0 0 VERTEX 8 0 10 0 20 0 30 0 42 1 0 VERTEX 8 0 10 40 20 0 30 0 42 1 0 SEQEND 8 0'
  draw 'LWPOLYLINE of four corners, 40 x 20' \
    '0 LWPOLYLINE 5 A1 100 AcDbEntity 8 0 100 AcDbPolyline 90 4 70 1 10 0 20 0 10 40 20 0 10 40 20 20 10 0 20 20'
  draw 'spline of 40 x 30' '0 SPLINE 5 A1 100 AcDbEntity 8 0 100 AcDbSpline 70 8 71 3 72 8 73 4 74 0
    40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 30 0 10 0 20 40 30 0 10 40 20 40 30 0 10 40 20 0 30 0'
} >seen
expect_in seen <<'END'
ellipse of 40 x 20: 20 x 10
upright ellipse of 20 x 40: 10 x 20
circle of 40: 40 x 40
LWPOLYLINE of two half circles, 40 x 40: 40 x 0
POLYLINE of two half circles, 40 x 40: 40 x 20
LWPOLYLINE of four corners, 40 x 20: 40 x 20
spline of 40 x 30: nothing
END
