#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenSCAD 2021.01 imports of a DXF what nobody sees in it: circles on layers that are off or frozen, invisible ones (group 60), and those
# of paper space, as parts of the model. It ignores extrusion directions: a circle mirrored by (0, 0, -1) comes at -50, not at 50.
# Believed: model space, as seen.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openscad=2021.01-6 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >write.py <<'PY'
import ezdxf
for name in ("seen", "off", "frozen", "invisible", "paper space", "extruded"):
    drawing = ezdxf.new("R2000")
    drawing.layers.add("off").off()
    drawing.layers.add("frozen").freeze()
    attributes = {"off": {"layer": "off"}, "frozen": {"layer": "frozen"}, "invisible": {"invisible": 1}, "extruded": {"extrusion": (0, 0, -1)}}
    space = drawing.layout("Layout1") if name == "paper space" else drawing.modelspace()
    drawing.modelspace().add_circle((0, 0), 10)
    space.add_circle((-50, 0) if name == "extruded" else (50, 0), 10, dxfattribs=attributes.get(name, {}))
    drawing.saveas(name + ".dxf")
PY
python3 write.py
for name in seen off frozen invisible 'paper space' extruded; do
  echo "import(\"$name.dxf\");" >model.scad
  openscad -o model.svg model.scad 2>messages
  echo "$name: $(grep -c WARNING messages || true) warnings, x from $(grep -o 'viewBox="[^"]*"' model.svg | sed 's/.*"\(-*[0-9]*\) [^ ]* \([0-9]*\) .*/\1, width \2/')"
done >seen
expect_in seen <<'END'
seen: 0 warnings, x from -10, width 70
off: 0 warnings, x from -10, width 70
frozen: 0 warnings, x from -10, width 70
invisible: 0 warnings, x from -10, width 70
paper space: 0 warnings, x from -10, width 70
extruded: 0 warnings, x from -60, width 70
END
