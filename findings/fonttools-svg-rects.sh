#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FontTools 4.38.0 (fontTools.svgLib) draws round rectangles of SVG with the radius as it is written, though it is more than half a side: a pill
# of 40 x 20 with rx="20" overlaps itself, so that its area is 457 instead of 714, and with rx="50" it is 80 high. It draws what <defs>, <symbol>, <clipPath> and display="none" hide, and no <use>, and
# not the place that a view box gives. Nothing is said. Paths, circles and smaller radii are right. Believed: as librsvg 2.54 does
# (SVG 1.1, 9.2: "If ry is greater than half of height, then set ry to half of height").
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-fonttools=4.38.0-1+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >draw.py <<'PY'
from fontTools.pens.areaPen import AreaPen
from fontTools.pens.boundsPen import BoundsPen
from fontTools.svgLib.path import SVGPath

RECT = '<rect width="40" height="20"/>'
for what, shapes, right in (
        ("rectangle", RECT, "0 0 40 20"),
        ("circle", '<circle cx="20" cy="10" r="10"/>', "10 0 30 20"),
        ("half circle", '<path d="M-20 0A20 20 0 0 1 20 0"/>', "-20 -20 20 0"),
        ("radius 5", '<rect width="40" height="20" rx="5"/>', "0 0 40 20, area 779"),
        ("radius 10", '<rect width="40" height="20" rx="10"/>', "0 0 40 20, area 714"),
        ("radius 20", '<rect width="40" height="20" rx="20"/>', "0 0 40 20, area 714"),
        ("radius 50", '<rect width="40" height="20" rx="50"/>', "0 0 40 20, area 714"),
        ("in defs", f"<defs>{RECT}</defs>", "nothing"),
        ("in a clip path", f'<clipPath id="c">{RECT}</clipPath>', "nothing"),
        ("not displayed", '<rect width="40" height="20" display="none"/>', "nothing"),
        ("used at x = 100", f'<defs><g id="g">{RECT}</g></defs><use href="#g" x="100"/>', "100 0 140 20")):
    pen = BoundsPen(None)
    SVGPath.fromstring(f'<svg xmlns="http://www.w3.org/2000/svg">{shapes}</svg>'.encode()).draw(pen)
    seen = " ".join(f"{round(value, 1):g}" for value in pen.bounds) if pen.bounds else "nothing"
    if "radius" in what:
        area = AreaPen()
        SVGPath.fromstring(f'<svg xmlns="http://www.w3.org/2000/svg">{shapes}</svg>'.encode()).draw(area)
        seen += f", area {abs(area.value):.0f}"
    print(f"{what}: {seen}" + ("" if seen == right else f", right is {right}"))
PY
/usr/bin/python3 draw.py >seen
expect_in seen <<'END'
rectangle: 0 0 40 20
circle: 10 0 30 20
half circle: -20 -20 20 0
radius 5: 0 0 40 20, area 779
radius 10: 0 0 40 20, area 714
radius 20: 0 0 40 20, area 457, right is 0 0 40 20, area 714
radius 50: -10 -30 50 50, area 1344, right is 0 0 40 20, area 714
in defs: 0 0 40 20, right is nothing
in a clip path: 0 0 40 20, right is nothing
not displayed: 0 0 40 20, right is nothing
used at x = 100: 0 0 40 20, right is 100 0 140 20
END
