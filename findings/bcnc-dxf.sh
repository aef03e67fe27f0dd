#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# bCNC 0.9.14 (sends G-code to mills) makes of a DXF other paths: blocks off by their base point, circles and polylines on a mirrored plane (extrusion
# direction down) unmirrored, polylines with the frame of the spline that was fitted to them, what is on layers that are off, or on paper space. Metres
# are millimetres if $MEASUREMENT stands behind $INSUNITS, a yard is 915.4 mm. Nothing is said of these. Frozen layers, other units,
# arcs of polylines and ellipses are right; that it does not turn blocks it says. Believed: the boxes that DXF's reference gives.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages bcnc=0.9.14.318+ds-4
export HOME=$work
cat >read.py <<'PY'
import sys
sys.path[:0] = ["root/usr/share/bcnc/bCNC", "root/usr/share/bcnc/bCNC/lib", "root/usr/lib/python3/dist-packages"]
from bpath import Path
from dxf import DXF

LINE = "0 LINE 8 0 10 3 20 4 11 13 21 9"
DOWN = "210 0 220 0 230 -1"
for what, entities, header, right in (
        ("a circle", "0 CIRCLE 8 0 10 5 20 0 40 2", "", "3 -2 to 7 2"),
        ("a mirrored circle", f"0 CIRCLE 8 0 10 5 20 0 40 2 {DOWN}", "", "-7 -2 to -3 2"),
        ("a mirrored polyline", f"0 LWPOLYLINE 8 0 90 2 70 0 10 0 20 0 10 10 20 5 {DOWN}", "", "-10 0 to 0 5"),
        ("a block", "0 INSERT 8 0 2 PART 10 20 20 30 30 0", "", "20 30 to 30 35"),
        ("an array of blocks", "0 INSERT 8 0 2 PART 10 20 20 30 30 0 70 2 44 100", "", "20 30 to 130 35"),
        ("a layer that is off", "0 LINE 8 OFF 10 0 20 0 11 10 21 5", "", "not milled"),
        ("a frozen layer", "0 LINE 8 FROZEN 10 0 20 0 11 10 21 5", "", "not milled"),
        ("paper space", "0 LINE 8 0 67 1 10 0 20 0 11 10 21 5", "", "not milled"),
        ("a polyline with the frame of its spline", "0 POLYLINE 8 0 66 1 10 0 20 0 30 0 70 4 " + " ".join(
            f"0 VERTEX 8 0 10 {x} 20 {y} 30 0 70 {flag}" for x, y, flag in (
                (0, 0, 16), (0, 40, 16), (40, 40, 16), (40, 0, 16), (0, 0, 8), (6.25, 22.5, 8), (20, 30, 8), (33.75, 22.5, 8), (40, 0, 8))) + " 0 SEQEND",
         "", "0 0 to 40 30"),
        ("metres", "0 LINE 8 0 10 0 20 0 11 1 21 2", "9 $INSUNITS 70 6", "0 0 to 1000 2000"),
        ("metres, then the metric system", "0 LINE 8 0 10 0 20 0 11 1 21 2", "9 $INSUNITS 70 6 9 $MEASUREMENT 70 1", "0 0 to 1000 2000"),
        ("yards", "0 LINE 8 0 10 0 20 0 11 10 21 20", "9 $INSUNITS 70 10", "0 0 to 9144 18288")):
    text = f"""0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 {header} 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 2 0 LAYER 2 0 70 0 62 7 6 CONTINUOUS
      0 LAYER 2 OFF 70 0 62 -7 6 CONTINUOUS 0 LAYER 2 FROZEN 70 1 62 7 6 CONTINUOUS 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS
      0 BLOCK 8 0 2 PART 70 0 10 3 20 4 30 0 3 PART {LINE} 0 ENDBLK 8 0 0 ENDSEC 0 SECTION 2 ENTITIES {entities} 0 ENDSEC 0 EOF"""
    with open("part.dxf", "w") as file:
        file.write("\n".join(text.split()) + "\n")
    drawing = DXF("part.dxf", "r")
    drawing.readFile()
    drawing.close()
    drawing.sort()
    drawing.convert2Polylines()
    drawing.expandBlocks()
    seen = []
    for name, layer in drawing.layers.items():
        entities = drawing.entities(name)
        if entities:
            path = Path(name)
            path.fromDxf(drawing, entities, DXF.MILLIMETERS)
            box = path.bbox()
            seen.append("not milled" if layer.isFrozen() else "{:.0f} {:.0f} to {:.0f} {:.0f}".format(*(round(value) + 0.0 for value in box)))
    print(f"{what}: {', '.join(seen)}" + ("" if ", ".join(seen) == right else f", right would be {right}"))
PY
python3 read.py 2>messages | grep ': ' >seen
expect_in seen <<'END'
a circle: 3 -2 to 7 2
a mirrored circle: 3 -2 to 7 2, right would be -7 -2 to -3 2
a mirrored polyline: 0 0 to 10 5, right would be -10 0 to 0 5
a block: 23 34 to 33 39, right would be 20 30 to 30 35
an array of blocks: 23 34 to 133 39, right would be 20 30 to 130 35
a layer that is off: 0 0 to 10 5, right would be not milled
a frozen layer: not milled
paper space: 0 0 to 10 5, right would be not milled
a polyline with the frame of its spline: 0 0 to 40 40, right would be 0 0 to 40 30
metres: 0 0 to 1000 2000
metres, then the metric system: 0 0 to 1 2, right would be 0 0 to 1000 2000
yards: 0 0 to 9154 18308, right would be 0 0 to 9144 18288
END
