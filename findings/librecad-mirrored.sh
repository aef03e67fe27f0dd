#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# LibreCAD 2.2.0 draws what lies on a mirrored plane (an extrusion direction down, as CAD programs write what is seen from behind) elsewhere: arcs of
# polylines bulge to the other side, ellipses are turned by half a turn, blocks are not mirrored. It draws the frame of a spline that was
# fitted to a polyline, and what is invisible (group 60) or on paper space, into the model. It says nothing. Mirrored circles, arcs and straight
# polylines, and blocks of a negative scale, are right. Believed: the boxes that DXF's reference gives.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages librecad=2.2.0-1 poppler-utils=22.12.0-2+deb12u3
export HOME=$work XDG_RUNTIME_DIR=$work QT_QPA_PLATFORM=offscreen QT_PLUGIN_PATH=$work/root/usr/lib/x86_64-linux-gnu/qt5/plugins
cat >draw.py <<'PY'
import re, subprocess

# Two lines that are 200 long, at the bottom and the top, tell the scale and the origin of the print.
FRAME = "0 LINE 8 0 10 -100 20 -100 11 100 21 -100 0 LINE 8 0 10 -100 20 100 11 100 21 100"
DOWN = "210 0 220 0 230 -1"
CORNERS = ((0, 0, 16), (0, 40, 16), (40, 40, 16), (40, 0, 16), (0, 0, 8), (6.25, 22.5, 8), (20, 30, 8), (33.75, 22.5, 8), (40, 0, 8))
for what, entities, right in (
        ("a circle", f"0 CIRCLE 8 0 10 50 20 0 30 0 40 10 {DOWN}", "-60 -10 to -40 10"),
        ("a polyline", f"0 LWPOLYLINE 8 0 90 2 70 0 {DOWN} 10 0 20 0 10 10 20 5", "-10 0 to 0 5"),
        ("a half circle as polyline", f"0 LWPOLYLINE 8 0 90 2 70 0 {DOWN} 10 0 20 0 42 1 10 10 20 0", "-10 -5 to 0 0"),
        ("a quarter of an ellipse", f"0 ELLIPSE 8 0 10 50 20 0 30 0 11 10 21 0 31 0 {DOWN} 40 0.5 41 0 42 1.5707963267948966", "50 -5 to 60 0"),
        ("a block", f"0 INSERT 8 0 2 PART 10 20 20 30 30 0 {DOWN}", "-30 30 to -20 35"),
        ("a block of scale -1", "0 INSERT 8 0 2 PART 10 20 20 30 30 0 41 -1 42 1 43 1", "10 30 to 20 35"),
        ("a polyline with the frame of its spline", "0 POLYLINE 8 0 66 1 10 0 20 0 30 0 70 4 " + " ".join(
            f"0 VERTEX 8 0 10 {x} 20 {y} 30 0 70 {flag}" for x, y, flag in CORNERS) + " 0 SEQEND 8 0", "0 0 to 40 30"),
        ("an invisible line", "0 LINE 8 0 60 1 10 0 20 0 30 0 11 10 21 5 31 0", "nothing"),
        ("paper space", "0 LINE 8 0 67 1 10 0 20 0 30 0 11 10 21 5 31 0", "nothing")):
    text = f"""0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 PART 70 0 10 0 20 0 30 0 3 PART
      0 LINE 8 0 10 0 20 0 30 0 11 10 21 5 31 0 0 ENDBLK 8 0 0 ENDSEC 0 SECTION 2 ENTITIES {FRAME} {entities} 0 ENDSEC 0 EOF"""
    with open("part.dxf", "w") as file:
        file.write("\n".join(text.split()) + "\n")
    subprocess.run(["timeout", "60", "librecad", "dxf2pdf", "-a", "-m", "-p", "200x200", "-o", "part.pdf", "part.dxf"], check=True, capture_output=True)
    subprocess.run(["pdftocairo", "-svg", "part.pdf", "part.svg"], check=True)
    paths = [[(float(x), float(y)) for x, y in re.findall(r"(-?[\d.]+) (-?[\d.]+)", path)] for path in
             re.findall(r'stroke:rgb.*? d="([^"]*)"', open("part.svg").read())]
    level = sorted((path for path in paths if len(path) == 2 and path[0][1] == path[1][1]), key=lambda path: -abs(path[1][0] - path[0][0]))[:2]
    (left, bottom), (right_end, _) = sorted(max(level, key=lambda path: path[0][1]))
    scale = 200 / (right_end - left)
    points = [((x - left) * scale - 100, (bottom - y) * scale - 100) for path in paths if path not in level for x, y in path]
    box = [round(limit(point[axis] for point in points)) for limit in (min, max) for axis in (0, 1)] if points else None
    seen = "{} {} to {} {}".format(*box) if box else "nothing"
    print(f"{what}: {seen}" + ("" if seen == right else f", right would be {right}"))
PY
python3 draw.py >seen
expect_in seen <<'END'
a circle: -60 -10 to -40 10
a polyline: -10 0 to 0 5
a half circle as polyline: -10 0 to 0 5, right would be -10 -5 to 0 0
a quarter of an ellipse: 40 0 to 50 5, right would be 50 -5 to 60 0
a block: 20 30 to 30 35, right would be -30 30 to -20 35
a block of scale -1: 10 30 to 20 35
a polyline with the frame of its spline: 0 0 to 40 40, right would be 0 0 to 40 30
an invisible line: 0 0 to 10 5, right would be nothing
paper space: 0 0 to 10 5, right would be nothing
END
