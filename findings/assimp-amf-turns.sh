#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# assimp 5.2.5 moves the parts of an AMF by what their constellations turn them: rz 90 lifts a part by 90 instead of turning it about z, rx
# 90 moves it along x. Moves, copies and nested constellations are right. Nothing is said. Believed: turns in degrees (ISO/ASTM 52915).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1
read_amf() {  # WHAT RIGHT CONSTELLATIONS
  python3 - "$3" >part.amf <<'PY'
import sys
print('<?xml version="1.0"?><amf unit="millimeter" version="1.1"><object id="1"><mesh><vertices>')
for c in range(8):
    x, y, z = 10 * (c & 1), 20 * (c >> 1 & 1), 30 * (c >> 2)
    print(f"<vertex><coordinates><x>{x}</x><y>{y}</y><z>{z}</z></coordinates></vertex>")
print("</vertices><volume>")
for facet in "0 2 3,0 3 1,4 5 7,4 7 6,0 1 5,0 5 4,2 6 7,2 7 3,0 4 6,0 6 2,1 3 7,1 7 5".split(","):
    print("<triangle>" + "".join(f"<v{k}>{v}</v{k}>" for k, v in enumerate(facet.split(), 1)) + "</triangle>")
print(f"</volume></mesh></object>{sys.argv[1]}</amf>")
PY
  assimp export part.amf part.obj >messages 2>&1 || { cat messages >&2; return 1; }
  awk '/^v / { print "v", $2, $3, $4 }' part.obj >corners  # colours stand behind
  echo "$1: $(extent corners); right would be $2"
}
at() { printf '<constellation id="%s"><instance objectid="%s">%s</instance></constellation>' "$1" "$2" "$3"; }
{
  read_amf "alone" "0..10 0..20 0..30" ""
  read_amf "moved" "50..60 0..20 0..30" "$(at 2 1 '<deltax>50</deltax>')"
  read_amf "moved twice" "50..60 40..60 0..30" "$(at 2 1 '<deltax>50</deltax>')$(at 3 2 '<deltay>40</deltay>')"
  read_amf "turned by 90 about z" "-20..0 0..10 0..30" "$(at 2 1 '<rz>90</rz>')"
  read_amf "turned by 90 about x" "0..10 -30..0 0..20" "$(at 2 1 '<rx>90</rx>')"
  read_amf "moved and turned by 180 about z" "40..50 -20..0 0..30" "$(at 2 1 '<deltax>50</deltax><rz>180</rz>')"
} >seen
expect_in seen <<'END'
alone: 0..10 0..20 0..30; right would be 0..10 0..20 0..30
moved: 50..60 0..20 0..30; right would be 50..60 0..20 0..30
moved twice: 50..60 40..60 0..30; right would be 50..60 40..60 0..30
turned by 90 about z: 0..10 0..20 90..120; right would be -20..0 0..10 0..30
turned by 90 about x: 90..100 0..20 0..30; right would be 0..10 -30..0 0..20
moved and turned by 180 about z: 50..60 0..20 180..210; right would be 40..50 -20..0 0..30
END
