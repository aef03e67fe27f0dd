#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# LibreCAD 2.2.0 does not read the patterns of a DXF's line types: it draws names that it knows by patterns of its own, and all others as
# continuous lines, so that hidden lines named HIDDEN_LINE, or ISO02W100, become visible ones. Believed: by the pattern in the table of line
# types (DXF, LTYPE, groups 40 and 49), here dashes of 10 mm and gaps of 5.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages librecad=2.2.0-1
export HOME=$work XDG_RUNTIME_DIR=$work QT_QPA_PLATFORM=offscreen QT_PLUGIN_PATH=$work/root/usr/lib/x86_64-linux-gnu/qt5/plugins
for name in HIDDEN HIDDEN2 ACAD_ISO02W100 ISO02W100 HIDDEN_LINE DASHES_10_5; do
  printf '%s\n' 0 SECTION 2 HEADER 9 '$ACADVER' 1 AC1015 9 '$INSUNITS' 70 4 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LTYPE 70 1 0 LTYPE 2 $name \
    70 0 3 '- -' 72 65 73 2 40 15 49 10 74 0 49 -5 74 0 0 ENDTAB 0 ENDSEC 0 SECTION 2 ENTITIES 0 LINE 8 0 6 $name 10 0 20 0 11 100 21 0 \
    0 LINE 8 0 10 0 20 10 11 100 21 10 0 ENDSEC 0 EOF >line.dxf
  timeout 60 librecad dxf2pdf -m -o line.pdf line.dxf >messages 2>&1 || { cat messages >&2; exit 1; }
  python3 - $name <<'PY'
import re, sys, zlib
page = zlib.decompress(re.search(rb"stream\n(.*?)\nendstream", open("line.pdf", "rb").read(), re.S)[1]).decode()
strokes, at = {}, None
for x, y, operator in re.findall(r"(\S+) (\S+) ([ml])\n", page.split(" d\n")[-1]):
    if operator == "l" and at and at[1] == y:
        strokes.setdefault(float(y), []).append(abs(float(x) - float(at[0])))
    at = x, y
solid, dashes = strokes[min(strokes)], strokes[max(strokes)]
print(f"{sys.argv[1]}: {len(dashes)} strokes, the second of {dashes[1] * 100 / solid[0]:.0f} mm" if len(dashes) > 1 else f"{sys.argv[1]}: continuous")
PY
done >seen
expect_in seen <<'END'
HIDDEN: 6 strokes, the second of 12 mm
HIDDEN2: 34 strokes, the second of 2 mm
ACAD_ISO02W100: 6 strokes, the second of 12 mm
ISO02W100: continuous
HIDDEN_LINE: continuous
DASHES_10_5: continuous
END
