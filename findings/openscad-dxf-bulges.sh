#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenSCAD 2021.01 imports arcs of DXF polylines (bulges, group 42), as CAD programs write slots, rounded corners and most outlines, as straight
# lines: a slot becomes a rectangle, a disc of two half circles nothing. Of an array of copies (INSERT, groups 70 and 44) there is one.
# Nothing is said of either. Believed: arcs by $fn, as the entities ARC and CIRCLE have them, and all copies.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openscad=2021.01-6
export HOME=$work
polyline() { echo "0 LWPOLYLINE 8 0 90 $(($# / 3)) 70 1 $(printf '10 %s 20 %s 42 %s ' "$@")"; }
area() {  # WHAT RIGHT ENTITIES [BLOCKS]
  tr -s ' ' '\n' <<<"0 SECTION 2 BLOCKS ${4:-} 0 ENDSEC 0 SECTION 2 ENTITIES $3 0 ENDSEC 0 EOF" >part.dxf
  echo 'linear_extrude(1) import("part.dxf", $fn = 360);' >part.scad
  rm -f part.stl
  openscad -o part.stl part.scad 2>messages || true
  touch part.stl
  awk -v what="$1" -v right="$2" '/vertex/ { n = n % 3 + 1; x[n] = $2; y[n] = $3; z[n] = $4 }
    /endloop/ { v += (x[1] * (y[2] * z[3] - z[2] * y[3]) + y[1] * (z[2] * x[3] - x[2] * z[3]) + z[1] * (x[2] * y[3] - y[2] * x[3])) / 6 }
    END { printf "area of %s: %.1f, right would be %s\n", what, v, right }' part.stl
  grep WARNING messages || true
}
{
  area "a square" 100.0 "$(polyline 0 0 0 10 0 0 10 10 0 0 10 0)"
  area "a slot, as a polyline" 278.5 "$(polyline 0 0 0 20 0 1 20 10 0 0 10 1)"
  area "the same slot, as lines and arcs" 278.5 "0 LINE 8 0 10 0 20 0 11 20 21 0 0 ARC 8 0 10 20 20 5 40 5 50 270 51 90 0 LINE 8 0 10 20 20 10 11 0 21 10 0 ARC 8 0 10 0 20 5 40 5 50 90 51 270"
  area "a square with round corners" 96.6 "$(polyline 2 0 0 8 0 .41421356 10 2 0 10 8 .41421356 8 10 0 2 10 .41421356 0 8 0 0 2 .41421356)"
  area "a disc, as a polyline" 78.5 "$(polyline 0 0 1 10 0 1)"
  area "a row of three squares" 300.0 "0 INSERT 8 0 2 A 10 0 20 0 70 3 44 20" "0 BLOCK 8 0 2 A 70 0 10 0 20 0 $(polyline 0 0 0 10 0 0 10 10 0 0 10 0) 0 ENDBLK"
} >seen
expect_in seen <<'END'
area of a square: 100.0, right would be 100.0
area of a slot, as a polyline: 200.0, right would be 278.5
area of the same slot, as lines and arcs: 278.5, right would be 278.5
area of a square with round corners: 92.0, right would be 96.6
area of a disc, as a polyline: 0.0, right would be 78.5
area of a row of three squares: 100.0, right would be 300.0
END
