#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# KLayout 0.28.5 makes areas of the closed outlines of a DXF (circles, polylines, hatches, rings of lines), but of a whole ellipse an open line
# without an area; it makes one outline of the frame and the points of a fitted polyline, leaves 3D faces out, and reads what lies in paper
# space. $INSUNITS is not heeded: millimetres and inches are both micrometres. Nothing is said. Bulges, mirrored planes, blocks, arrays and
# weights of splines are right. Believed: an area, the curve, and sizes in the unit that the file names.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages klayout=0.28.5-2
export LD_LIBRARY_PATH=$work/root/usr/lib/klayout:$LD_LIBRARY_PATH PYTHONPATH=$work/root/usr/lib/klayout/pymod
cat >read.py <<'PY'
import math
import klayout.db as db


def group(*pairs):
    return "".join(f"{code}\n{value}\n" for code, value in pairs)


def outline(points, *more):
    return group((0, "LWPOLYLINE"), (8, 0), (90, len(points)), (70, 1), *more) + group(*[pair for x, y in points for pair in ((10, x), (20, y))])


def vertices(points, flag):
    return "".join(group((0, "VERTEX"), (8, 0), (10, x), (20, y), (70, flag)) for x, y in points)


BOX = [(0, 0), (10, 0), (10, 20), (0, 20)]
CURVE = [(10 + 6 * math.cos(k * math.pi / 8), 10 + 6 * math.sin(k * math.pi / 8)) for k in range(16)]
for what, unit, entities, right in (
        ("box, mm", 4, outline(BOX), "0 0 10000 20000, area 200000000"),
        ("box, inches", 1, outline(BOX), "0 0 254000 508000, area 129032000000"),
        ("circle", 4, group((0, "CIRCLE"), (8, 0), (10, 0), (20, 0), (40, 10)), "-10000 -10000 10000 10000, area 314159265"),
        ("ellipse", 4, group((0, "ELLIPSE"), (8, 0), (10, 0), (20, 0), (11, 20), (21, 0), (40, 0.5), (41, 0), (42, 2 * math.pi)),
         "-20000 -10000 20000 10000, area 628318531"),
        ("fitted polyline", 4, group((0, "POLYLINE"), (8, 0), (66, 1), (70, 5), (75, 6)) + vertices(BOX, 16) + vertices(CURVE, 8) + group((0, "SEQEND"), (8, 0)),
         "4000 4000 16000 16000, area 110211000"),
        ("3D face", 4, group((0, "3DFACE"), (8, 0), *[pair for k, (x, y) in enumerate(BOX) for pair in ((10 + k, x), (20 + k, y), (30 + k, 0))]),
         "0 0 10000 20000, area 200000000"),
        ("paper space", 4, outline(BOX, (67, 1)), "nothing")):
    with open("part.dxf", "w") as file:
        file.write(group((0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1015"), (9, "$INSUNITS"), (70, unit), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES"))
                   + entities + group((0, "ENDSEC"), (0, "EOF")))
    layout, seen = db.Layout(), "nothing"
    layout.read("part.dxf")
    for layer in layout.layer_indexes():
        for cell in layout.top_cells():
            shapes, box = db.Region(cell.begin_shapes_rec(layer)), cell.bbox_per_layer(layer)
            if not box.empty():
                place = " ".join(f"{value * layout.dbu:.0f}" for value in (box.left, box.bottom, box.right, box.top))
                seen = f"{place}, area {shapes.area() * layout.dbu ** 2:.0f}"
    print(f"{what}, in micrometres: {seen}; right is {right}")
PY
/usr/bin/python3 read.py >seen
expect_in seen <<'END'
box, mm, in micrometres: 0 0 10 20, area 200; right is 0 0 10000 20000, area 200000000
box, inches, in micrometres: 0 0 10 20, area 200; right is 0 0 254000 508000, area 129032000000
circle, in micrometres: -10 -10 10 10, area 314; right is -10000 -10000 10000 10000, area 314159265
ellipse, in micrometres: -20 -10 20 10, area 0; right is -20000 -10000 20000 10000, area 628318531
fitted polyline, in micrometres: 0 0 16 20, area 130; right is 4000 4000 16000 16000, area 110211000
3D face, in micrometres: nothing; right is 0 0 10000 20000, area 200000000
paper space, in micrometres: 0 0 10 20, area 200; right is nothing
END
