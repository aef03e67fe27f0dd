#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Slic3r 1.3.0 takes the degrees by which an AMF turns a part for radians (a quarter of a turn becomes 117 degrees), does not turn it about x,
# ignores constellations within constellations, and the unit of the file: 10 mm said in inches are printed 0.4 mm wide. Nothing is said.
# Believed: degrees, all axes, nested constellations and units, as ISO/ASTM 52915 has them. Widths below are those of the
# middle of the outer thread, about 0.1 mm within each side.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages slic3r=1.3.0+dfsg1-5+b2
arch=$work/root/usr/lib/x86_64-linux-gnu/perl
export HOME=$work PERL5LIB=$work/root/usr/lib/slic3r:$work/root/usr/share/perl5:${arch}5/5.36:$work/root/usr/share/perl/5.36:$arch/5.36
slice() {  # WHAT RIGHT UNIT WIDTH CONSTELLATIONS
  python3 - "$3" "$4" "$5" >part.amf <<'PY'
import sys
unit, width, rest = sys.argv[1:]
facets = "0 2 3,0 3 1,4 5 7,4 7 6,0 1 5,0 5 4,2 6 7,2 7 3,0 4 6,0 6 2,1 3 7,1 7 5".split(",")
print(f'<?xml version="1.0"?><amf unit="{unit}" version="1.1"><object id="1"><mesh><vertices>')
for c in range(8):
    x, y, z = (float(width) * (c >> axis & 1) for axis in range(3))
    print(f"<vertex><coordinates><x>{x}</x><y>{y}</y><z>{z}</z></coordinates></vertex>")
print("</vertices><volume>")
for facet in facets:
    print("<triangle>" + "".join(f"<v{k}>{v}</v{k}>" for k, v in enumerate(facet.split(), 1)) + "</triangle>")
print(f"</volume></mesh></object>{rest}</amf>")
PY
  slic3r --skirts 0 --start-gcode '' --end-gcode '' --layer-height 0.1 --first-layer-height 0.1 --dont-arrange -o part.gcode part.amf >messages 2>&1 || { cat messages >&2; return 1; }
  awk -v what="$1" -v right="$2" '/^G1/ { for (i = 2; i <= NF; ++i) { a = substr($i, 1, 1); v[a] = substr($i, 2) + 0; if (a == "Z") up = v[a] < 100 ? v[a] : up } }
    /^G1 X.*E/ { for (i = 1; i <= 2; ++i) { a = substr("XY", i, 1); if (!n || v[a] < low[a]) low[a] = v[a]; if (!n || v[a] > high[a]) high[a] = v[a] } n = 1; if (up > top) top = up }
    END { printf "%s: x %.1f..%.1f, y %.1f..%.1f, %.1f high; the body would be %s\n", what, low["X"], high["X"], low["Y"], high["Y"], top, right }' part.gcode
}
at() { printf '<constellation id="%s"><instance objectid="%s">%s</instance></constellation>' "$1" "$2" "$3"; }
moved='<deltax>50</deltax><deltay>50</deltay>'
{
  slice "moved" "x 50..60, y 50..60, 10 high" millimeter 10 "$(at 2 1 "$moved")"
  slice "turned by 90 about z" "x 40..50, y 50..60, 10 high" millimeter 10 "$(at 2 1 "$moved<rz>90</rz>")"
  slice "turned by 45 about x" "x 50..60, y 42.9..57.1, 14.1 high" millimeter 10 "$(at 2 1 "$moved<rx>45</rx>")"
  slice "moved twice" "x 80..90, y 50..60, 10 high" millimeter 10 "$(at 2 1 "$moved")$(at 3 2 '<deltax>30</deltax>')"
  slice "in inches" "x 50..60, y 50..60, 10 high" inch 0.3937 "$(at 2 1 '<deltax>1.9685</deltax><deltay>1.9685</deltay>')"
} >seen
expect_in seen <<'END'
moved: x 50.1..59.9, y 50.1..59.9, 10.0 high; the body would be x 50..60, y 50..60, 10 high
turned by 90 about z: x 36.7..49.9, y 45.7..58.8, 10.0 high; the body would be x 40..50, y 50..60, 10 high
turned by 45 about x: x 50.1..59.9, y 50.1..59.9, 10.0 high; the body would be x 50..60, y 42.9..57.1, 14.1 high
moved twice: x 50.1..59.9, y 50.1..59.9, 10.0 high; the body would be x 80..90, y 50..60, 10 high
in inches: x 2.1..2.3, y 2.1..2.3, 0.1 high; the body would be x 50..60, y 50..60, 10 high
END
