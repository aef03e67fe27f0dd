#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# LibreOffice Draw 7.4.7 gives every DXF one size: of drawings 1, 100 and 5000 mm wide each comes out 100 mm wide in the PDF. If the
# header tells an extent ($EXTMIN, $EXTMAX) it goes by that: of one that is too small, as after an addition, the rest is clipped off;
# and the empty one of 1E+20, with which ezdxf begins, makes the whole drawing one point. Nothing is said. Believed: 1:1, or fitted to
# what the drawing holds.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libreoffice-draw=4:7.4.7-1+deb12u14 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work
export LD_LIBRARY_PATH=$work/root/usr/lib/libreoffice/program:$LD_LIBRARY_PATH
# Debian's settings name the folders of an installation.
library=$work/root/usr/lib/libreoffice
sed -i -e "s,file:///etc/libreoffice/registry,file://$library/share/.registry,g" -e "s,file:///usr/lib/libreoffice,file://$library,g" "$library"/program/*rc
drawing() {  # NAME WIDTH HEADER...
  local name=$1 width=$2
  shift 2
  printf '%s\n' 0 SECTION 2 HEADER 9 '$ACADVER' 1 AC1015 9 '$INSUNITS' 70 4 "$@" 0 ENDSEC 0 SECTION 2 ENTITIES >"$name.dxf"
  printf '%s\n' 0 LINE 8 0 10 0 20 0 11 "$width" 21 0 0 LINE 8 0 10 "$width" 20 0 11 "$width" 21 "$width" 0 ENDSEC 0 EOF >>"$name.dxf"
}
extent() { printf '%s\n' 9 '$EXTMIN' 10 "$1" 20 "$1" 30 0 9 '$EXTMAX' 10 "$2" 20 "$2" 30 0; }
drawing '1 mm' 1
drawing '100 mm' 100
drawing '5000 mm' 5000
drawing '5000 mm, extent right' 5000 $(extent 0 5000)
drawing '5000 mm, extent half' 5000 $(extent 0 2500)
drawing '5000 mm, extent empty' 5000 $(extent 1E+20 -1E+20)
python3 - <<'PY'
import ezdxf
drawing = ezdxf.new("R2000")
drawing.modelspace().add_line((0, 0), (100, 0))
drawing.modelspace().add_line((100, 0), (100, 100))
drawing.saveas("100 mm by ezdxf.dxf")
PY
for name in '1 mm' '100 mm' '5000 mm' '5000 mm, extent right' '5000 mm, extent half' '5000 mm, extent empty' '100 mm by ezdxf'; do
  timeout 120 root/usr/lib/libreoffice/program/soffice --headless --convert-to pdf "$name.dxf" >messages 2>&1 || { cat messages >&2; exit 1; }
  python3 - "$name" <<'PY'
import re, sys, zlib
streams = (zlib.decompressobj().decompress(part) for part in re.findall(rb"FlateDecode>>\r?\nstream\r?\n(.*?)\r?\nendstream", open(sys.argv[1] + ".pdf", "rb").read(), re.S))
page, mm, points, clip, ends = next(streams).decode(), 25.4 / 72, [], None, []
for *values, operator in (line.split() for line in re.sub(r" (re|m|l|S)(?=\s)", r" \1\n", page).split("\n") if line.strip()):
    if operator == "re":
        clip = [float(values[-4]), float(values[-4]) + float(values[-2])]
    elif operator in ("m", "l"):
        ends.append(float(values[-2]))
    elif operator == "S":
        points, ends = points + ends, []
    elif operator[0] in "fnW":
        ends = []
drawn = (max(points) - min(points)) * mm if points else 0
left = (min(max(points), clip[1]) - max(min(points), clip[0])) * mm if points else 0
print(f"{sys.argv[1]}: {drawn:.0f} mm wide, {left:.0f} of it within the clip")
PY
done >seen
expect_in seen <<'END'
1 mm: 100 mm wide, 100 of it within the clip
100 mm: 100 mm wide, 100 of it within the clip
5000 mm: 100 mm wide, 100 of it within the clip
5000 mm, extent right: 100 mm wide, 100 of it within the clip
5000 mm, extent half: 200 mm wide, 100 of it within the clip
5000 mm, extent empty: 0 mm wide, 0 of it within the clip
100 mm by ezdxf: 0 mm wide, 0 of it within the clip
END
