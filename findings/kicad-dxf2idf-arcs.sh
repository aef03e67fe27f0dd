#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# KiCad 6.0.11's dxf2idf, which makes component outlines of DXF, takes the angles of arcs for radians: a slot of two lines and two arcs
# becomes two points and an arc of 10313 degrees. Arcs of polylines become straight, but for one that begins at the first corner of a
# closed one, which is drawn at the last side. Nothing is said of either. Believed: half circles at the sides of 20 mm.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages kicad=6.0.11+dfsg-1
dxf() {  # FILE: the entities on standard input, of which / divides the lines
  { printf '%s\n' 0 SECTION 2 ENTITIES; tr '/' '\n'; printf '%s\n' 0 ENDSEC 0 EOF; } >"$1"
}
line() { echo "0/LINE/8/0/10/$1/20/$2/30/0/11/$3/21/$4/31/0"; }
arc() { echo "0/ARC/8/0/10/$1/20/$2/30/0/40/10/50/$3/51/$4"; }
corner() { echo "0/VERTEX/8/0/10/$1/20/$2/30/0/42/$3"; }
{ line 0 0 30 0; line 30 0 30 20; line 30 20 0 20; line 0 20 0 0; } | dxf lines.dxf
{ line 0 0 30 0; arc 30 10 270 90; line 30 20 0 20; arc 0 10 90 270; } | dxf arcs.dxf
{ echo '0/POLYLINE/8/0/66/1/70/1'; corner 0 0 0; corner 30 0 1; corner 30 20 0; corner 0 20 1; echo '0/SEQEND/8/0'; } | dxf polyline.dxf
{ echo '0/POLYLINE/8/0/66/1/70/1'; corner 0 20 1; corner 0 0 0; corner 30 0 0; corner 30 20 0; echo '0/SEQEND/8/0'; } | dxf first.dxf
for name in lines arcs polyline first; do
  printf '%s\n' $name.dxf mm SLOT PART 5 '' $name.idf | dxf2idf >$name.log
  echo "$name:"
  awk 'NF == 4 && $1 == 0 { printf "  %.3f %.3f by an arc of %.2f\n", $2, $3, $4 }' $name.idf
done >seen
expect_in seen <<'END'
lines:
  0.000 0.000 by an arc of 0.00
  30.000 0.000 by an arc of 0.00
  30.000 20.000 by an arc of 0.00
  0.000 20.000 by an arc of 0.00
  0.000 0.000 by an arc of 0.00
arcs:
  -4.481 18.940 by an arc of 0.00
  9.844 8.240 by an arc of 10313.24
  -4.481 18.940 by an arc of 0.00
polyline:
  0.000 0.000 by an arc of 0.00
  30.000 0.000 by an arc of 0.00
  30.000 20.000 by an arc of 0.00
  0.000 20.000 by an arc of 0.00
  0.000 0.000 by an arc of 0.00
first:
  0.000 20.000 by an arc of 0.00
  0.000 0.000 by an arc of 0.00
  30.000 0.000 by an arc of 0.00
  30.000 20.000 by an arc of 0.00
  0.000 20.000 by an arc of 180.00
END
