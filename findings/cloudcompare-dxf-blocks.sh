#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# CloudCompare 2.11.3 makes bodies of the blocks of a DXF where they are defined, once each, whether they are inserted anywhere or not: a part
# that was deleted from the drawing, and whose block remained, is there, and one inserted twice at 100 and 200 is once at the origin. Meshes
# of polylines (polyface) it leaves out. It ends with success and names none of it. 3DFACEs of the drawing itself are right. Believed: what the
# drawing shows: INSERT places a block, BLOCK alone draws nothing (DXF reference, BLOCKS and ENTITIES sections).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages cloudcompare=2.11.3-7.1 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work QT_QPA_PLATFORM=offscreen
export LD_LIBRARY_PATH=$work/root/usr/lib/x86_64-linux-gnu/cloudcompare:$LD_LIBRARY_PATH
export QT_PLUGIN_PATH=$work/root/usr/lib/x86_64-linux-gnu/qt5/plugins
cat >draw.py <<'PY'
import sys
import ezdxf

drawing = ezdxf.new("R2000")
model, part = drawing.modelspace(), drawing.blocks.new("PART")

def facet(layout, x):
    layout.add_3dface([(x, 0, 0), (x + 10, 0, 0), (x, 10, 5)])

facet(part, 0)
facet(model, 50)
if sys.argv[1] == "inserted":
    model.add_blockref("PART", (100, 0))
    model.add_blockref("PART", (200, 0))
if sys.argv[1] == "polyface":
    model.add_polyface().append_face([(300, 0, 0), (310, 0, 0), (300, 10, 5)])
drawing.saveas(f"{sys.argv[1]}.dxf")
PY
for name in defined inserted polyface; do
  python3 draw.py "$name"
  CloudCompare -SILENT -O "$name.dxf" -AUTO_SAVE OFF -M_EXPORT_FMT OBJ -SAVE_MESHES FILE "$name.obj" >messages 2>&1
  echo "$name: $(grep -c '^f ' "$name.obj") facets from x $(awk '$1 == "v" { printf "%d ", $2 }' "$name.obj" | xargs -n 3 | cut -d' ' -f1 | xargs)"
done >seen
expect_in seen <<'END'
defined: 2 facets from x 0 50
inserted: 2 facets from x 0 50
polyface: 2 facets from x 0 50
END
