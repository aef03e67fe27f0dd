#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# LibreCAD 2.2.0 (dxf2pdf) prints lines on layers that are switched off (negative colour); those on layers that are
# frozen it does not print. Believed: neither of the two.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages librecad=2.2.0-1 python3-ezdxf=0.18.1-1 poppler-utils=22.12.0-2+deb12u3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work XDG_RUNTIME_DIR=$work QT_QPA_PLATFORM=offscreen
export QT_PLUGIN_PATH=$work/root/usr/lib/x86_64-linux-gnu/qt5/plugins
cat >write.py <<'PY'
import ezdxf
drawing = ezdxf.new("R2000")
drawing.header["$INSUNITS"] = 4
drawing.layers.add("off").off()
drawing.layers.add("frozen").freeze()
space = drawing.modelspace()
for y, attributes in ((10, {}), (20, {"layer": "off"}), (30, {"layer": "frozen"})):
    space.add_line((0, y), (y, y), dxfattribs=attributes)  # as long as it is high
drawing.saveas("lines.dxf")
PY
python3 write.py
timeout 60 librecad dxf2pdf -a -m -p 100x100 -o lines.pdf lines.dxf >messages 2>&1 || { cat messages >&2; exit 1; }
pdftocairo -svg lines.pdf lines.svg
python3 - >seen <<'PY'
import re
lines = [[float(x) for x in ends] for ends in re.findall(r' d="M ([0-9.]+) ([0-9.]+) L ([0-9.]+) \2 "', open("lines.svg").read())]
lengths = [round(10 * (end - begin) / (lines[0][2] - lines[0][0])) for begin, _, end in lines]
for name, length in (("seen", 10), ("off", 20), ("frozen", 30)):
    print(f"{name}: {'printed' if length in lengths else 'absent'}")
PY
expect_in seen <<'END'
seen: printed
off: printed
frozen: absent
END
