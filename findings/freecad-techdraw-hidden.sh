#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2: a TechDraw page written as DXF (writeDXFPage) has hidden lines on the layer of the visible ones and as continuous as they
# are, so that nobody can tell a blind hole in the back from one in the front; and those behind visible lines a second time.
# viewPartAsSvg gives hidden lines no dashes either. Believed: a layer or a line type of their own, as the page shows them.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work QT_QPA_PLATFORM=offscreen
cat >blank.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210"></svg>
SVG
cat >page.py <<'PY'
import FreeCAD, Part, TechDraw
from FreeCAD import Vector

document = FreeCAD.newDocument("d")
part = document.addObject("Part::Feature", "Part")
part.Shape = Part.makeBox(40, 30, 20).cut(Part.makeCylinder(3, 10, Vector(10, 20, 5), Vector(0, 1, 0)))
page, template = document.addObject("TechDraw::DrawPage", "Page"), document.addObject("TechDraw::DrawSVGTemplate", "Template")
template.Template = "blank.svg"
page.Template = template
view = document.addObject("TechDraw::DrawViewPart", "Front")
page.addView(view)
view.Source, view.Direction, view.X, view.Y = [part], Vector(0, -1, 0), 100, 100
for view.HardHidden in (False, True):
    document.recompute()
    TechDraw.writeDXFPage(page, "page.dxf")
    tags = [line.strip() for line in open("page.dxf")]
    pairs, things = list(zip(tags[::2], tags[1::2])), []
    for code, value in pairs[pairs.index(("2", "ENTITIES")) + 1 :]:
        if code == "0":
            things.append({"type": value})
        elif things and code in ("6", "8"):
            things[-1][code] = value
    drawn = [thing for thing in things if "8" in thing]
    print(f"hidden lines {'on' if view.HardHidden else 'off'}:", *sorted({
        f"{sum(other == thing for other in drawn)} {thing['type']} on layer {thing['8']}, line type {thing.get('6', 'of its layer')};"
        for thing in drawn}))
    print("line types of layers:", *sorted({pairs[i + k][1] for i, pair in enumerate(pairs) if pair == ("0", "LAYER")
                                            for k in range(1, 12) if pairs[i + k][0] == "6"}))
    picture = TechDraw.viewPartAsSvg(view)
    print("SVG:", picture.count("<path") + picture.count("<circle"), "lines,", picture.count("dash"), "dashed")
PY
python3 page.py >output 2>messages || { cat messages; exit 1; }
grep -E '^(hidden|line|SVG)' output >seen
expect_in seen <<'END'
hidden lines off: 4 LINE on layer Front, line type of its layer;
line types of layers: CONTINUOUS
SVG: 4 lines, 0 dashed
hidden lines on: 2 CIRCLE on layer Front, line type of its layer; 8 LINE on layer Front, line type of its layer;
line types of layers: CONTINUOUS
SVG: 10 lines, 0 dashed
END
