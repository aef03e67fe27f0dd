#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2's import of SVG (importSVG) applies a list of transforms in the wrong order, so that "translate(10) scale(2)" moves by 20; it
# flattens arcs whose radii are too small and are to be enlarged, loses paths whose arc flags have no separators, ignores where the
# view box begins, where an inner svg stands and where a use moves its copy, and draws what is hidden. Nothing is said. Believed: as librsvg
# 2.54 draws them (SVG 1.1, 7.6, 8.3.8 and F.6.6); y points up in FreeCAD, and is turned back here.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1 freecad-common=0.20.2+dfsg1-4+deb12u1 python3-pyside2.qtwidgets=5.15.8-2+b1 python3-pyside2.qtsvg=5.15.8-2+b1 python3-six=1.16.0-4
export HOME=$work QT_QPA_PLATFORM=offscreen
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib:$work/root/usr/share/freecad/Ext:$work/root/usr/share/freecad/Mod/Draft
cat >svg.py <<'PY'
import FreeCAD
import importSVG

SQUARE = '<rect x="10" y="10" width="20" height="10"/>'
LINE, ARC = '<path d="M10 50h20"{}/>', '<path d="M10 50{}"/>'
cases = {
    "plain": (SQUARE, "10 10 to 30 20"),
    "translate(10 5) scale(2)": (LINE.format(' transform="translate(10 5) scale(2)"'), "30 105 to 70 105"),
    "translate(60) scale(-1 1)": (LINE.format(' transform="translate(60) scale(-1 1)"'), "30 50 to 50 50"),
    "translate(10) rotate(90)": (LINE.format(' transform="translate(10) rotate(90)"'), "-40 10 to -40 30"),
    "the same as two groups": ('<g transform="translate(10)"><g transform="rotate(90)">' + LINE.format("") + "</g></g>", "-40 10 to -40 30"),
    "half a circle": (ARC.format("A10 10 0 0 1 30 50"), "10 40 to 30 50"),
    "the same, of a radius to be enlarged": (ARC.format("A5 5 0 0 1 30 50"), "10 40 to 30 50"),
    "the same, flags without separators": (ARC.format("a10 10 0 0120 0"), "10 40 to 30 50"),
    "view box from -10 -10": (SQUARE, "20 20 to 40 30", "-10 -10"),
    "inner svg at 10 10": ('<svg x="10" y="10">' + SQUARE + "</svg>", "20 20 to 40 30"),
    "use, 30 to the right": ('<defs><g id="a">' + SQUARE + '</g></defs><use xlink:href="#a" x="30"/>', "40 10 to 60 20"),
    "hidden": ('<g display="none">' + SQUARE + "</g>", "nothing"),
}
for what, (body, right, *start) in cases.items():
    with open("sheet.svg", "w") as sheet:
        sheet.write(f'<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="100mm" height="100mm" viewBox="{(start or ["0 0"])[0]} 100 100">{body}</svg>')
    document = FreeCAD.newDocument("sheet")
    importSVG.insert("sheet.svg", document.Name)
    box = FreeCAD.BoundBox()
    for thing in document.Objects:
        box.add(thing.Shape.optimalBoundingBox(False))
    seen = f"{box.XMin + 0:.1f} {-box.YMax + 0:.1f} to {box.XMax + 0:.1f} {-box.YMin + 0:.1f}".replace("-0.0", "0.0").replace(".0", "") if document.Objects else "nothing"
    print(f"{what}: {seen}" + (f", right would be {right}" if seen != right else ""))
    FreeCAD.closeDocument(document.Name)
PY
python3 svg.py >output 2>messages || { tail -n 3 messages; exit 1; }
grep ': ' output >seen
expect_in seen <<'END'
plain: 10 10 to 30 20
translate(10 5) scale(2): 40 110 to 80 110, right would be 30 105 to 70 105
translate(60) scale(-1 1): -90 50 to -70 50, right would be 30 50 to 50 50
translate(10) rotate(90): -50 20 to -50 40, right would be -40 10 to -40 30
the same as two groups: -40 10 to -40 30
half a circle: 10 40 to 30 50
the same, of a radius to be enlarged: 10 45 to 30 50, right would be 10 40 to 30 50
the same, flags without separators: nothing, right would be 10 40 to 30 50
view box from -10 -10: 10 10 to 30 20, right would be 20 20 to 40 30
inner svg at 10 10: 10 10 to 30 20, right would be 20 20 to 40 30
use, 30 to the right: 10 10 to 30 20, right would be 40 10 to 60 20
hidden: 10 10 to 30 20, right would be nothing
END
