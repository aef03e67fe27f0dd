#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Blender 3.4.1's import of SVG: what is hidden by display is drawn, copies by href (SVG 2) are left out, a view box that does not begin
# at 0 0 moves everything, and an inner svg is a fifth as large as it says. Nothing is said. Believed: a rectangle of 20 x 10 mm
# from 10, 30 (Blender counts from the bottom), and a second one 50 mm further only in the cases "xlink" and "href".
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages blender=3.4.1+dfsg-2+b1
sheet() {  # NAME VIEWBOX CONTENT
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"100mm\" height=\"50mm\" viewBox=\"$2\">$3</svg>" >"$1.svg"
}
first='<path id="a" d="M10 10H30V20H10Z"/>'
sheet plain '0 0 100 50' "$first"
sheet xlink '0 0 100 50' "$first<use xlink:href=\"#a\" x=\"50\"/>"
sheet href '0 0 100 50' "$first<use href=\"#a\" x=\"50\"/>"
sheet hidden '0 0 100 50' "$first<g display=\"none\"><path d=\"M60 10H80V20H60Z\"/></g>"
sheet origin '-50 -25 100 50' '<path d="M-40 -15H-20V-5H-40Z"/>'
sheet inner '0 0 100 50' '<svg x="10" y="10" width="20" height="10" viewBox="0 0 10 5"><path d="M0 0H10V5H0Z"/></svg>'
cat >places.py <<'PY'
import bpy
from mathutils import Vector

for name in ("plain", "xlink", "href", "hidden", "origin", "inner"):
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    bpy.ops.import_curve.svg(filepath=name + ".svg")
    bpy.context.view_layer.update()
    boxes = []
    for item in bpy.data.objects:
        corners = [item.matrix_world @ Vector(corner) * 1000 for corner in item.bound_box]
        boxes.append([round(extreme(corner[axis] for corner in corners), 1) for extreme in (min, max) for axis in (0, 1)])
    print("mm of", name, *("%g %g to %g %g;" % tuple(box) for box in sorted(boxes)))
PY
export BLENDER_SYSTEM_SCRIPTS=$work/root/usr/share/blender/scripts BLENDER_SYSTEM_DATAFILES=$work/root/usr/share/blender/datafiles HOME=$work
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/share/blender/scripts/modules
blender -b --factory-startup -P places.py >output 2>&1 || { cat output; exit 1; }
grep '^mm of' output >seen
expect_in seen <<'END'
mm of plain 10 30 to 30 40;
mm of xlink 10 30 to 30 40; 60 30 to 80 40;
mm of href 10 30 to 30 40;
mm of hidden 10 30 to 30 40; 60 30 to 80 40;
mm of origin -25.9 22.9 to -5.9 32.9;
mm of inner 10 40 to 14 42;
END
