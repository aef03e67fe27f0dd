#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# SpatiaLite 5.0.1 (spatialite_dxf) makes a point of a block of DXF whose scale is left out, which is then 1; turns blocks the other way round, scales them
# after the turn, and leaves out their base point and all but one of an array. Arcs of polylines become chords, ellipses and splines are left
# out, circles on a mirrored plane (extrusion direction down) lie unmirrored. It ends with success and a report of what it read.
# Circles, arcs and closed polylines are right. Believed: the boxes that DXF's reference gives.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages spatialite-bin=5.0.1-2
seen() {  # WHAT TABLE ENTITIES RIGHT
  local line='0 LINE 8 0 10 3 20 4 30 0 11 13 21 9 31 0'
  rm -f part.sqlite
  printf '%s\n' 0 SECTION 2 HEADER 9 '$ACADVER' 1 AC1015 0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 PART 70 0 10 0 20 0 30 0 3 PART $line 0 ENDBLK 8 0 \
    0 BLOCK 8 0 2 BASED 70 0 10 3 20 4 30 0 3 BASED $line 0 ENDBLK 8 0 0 ENDSEC 0 SECTION 2 ENTITIES $3 0 ENDSEC 0 EOF >part.dxf
  spatialite_dxf -d part.sqlite -x part.dxf >messages 2>&1
  local box
  box=$(spatialite part.sqlite "select round(min(MbrMinX(geometry))) || ' ' || round(min(MbrMinY(geometry))) || ' to ' ||
    round(max(MbrMaxX(geometry))) || ' ' || round(max(MbrMaxY(geometry))) from \"$2\"" 2>/dev/null | sed 's/\.0//g') || true
  [ "$box" = "$4" ] && echo "$1: $box" || echo "$1: ${box:-nothing}, right would be $4"
}
{
  insert='0 INSERT 8 0 10 100 20 0 30 0'
  view=0_insline_2d_view
  seen 'a block of scale 1' $view "$insert 2 PART 41 1 42 1 43 1" '103 4 to 113 9'
  seen 'without scale' $view "$insert 2 PART" '103 4 to 113 9'
  seen 'turned by 90 degrees' $view "$insert 2 PART 41 1 42 1 43 1 50 90" '91 3 to 96 13'
  seen 'twice as wide, turned by 90 degrees' $view "$insert 2 PART 41 2 42 1 43 1 50 90" '91 6 to 96 26'
  seen 'with a base point' $view "$insert 2 BASED 41 1 42 1 43 1" '100 0 to 110 5'
  seen 'three in a row' $view "$insert 2 PART 41 1 42 1 43 1 70 3 44 50" '103 4 to 213 9'
  seen 'a circle' 0_line_2d '0 CIRCLE 8 0 10 50 20 0 30 0 40 20' '30 -20 to 70 20'
  seen 'a mirrored circle' 0_line_2d '0 CIRCLE 8 0 10 50 20 0 30 0 40 20 210 0 220 0 230 -1' '-70 -20 to -30 20'
  seen 'a half circle as polyline' 0_line_2d '0 LWPOLYLINE 8 0 90 2 70 0 10 0 20 0 42 1 10 40 20 0' '0 -20 to 40 0'
  seen 'an ellipse' 0_line_2d '0 ELLIPSE 8 0 10 50 20 0 30 0 11 20 21 0 31 0 210 0 220 0 230 1 40 0.5 41 0 42 6.283185307179586' '30 -10 to 70 10'
} >seen
expect_in seen <<'END'
a block of scale 1: 103 4 to 113 9
without scale: 100 0 to 100 0, right would be 103 4 to 113 9
turned by 90 degrees: 104 -13 to 109 -3, right would be 91 3 to 96 13
twice as wide, turned by 90 degrees: 108 -13 to 118 -3, right would be 91 6 to 96 26
with a base point: 103 4 to 113 9, right would be 100 0 to 110 5
three in a row: 103 4 to 113 9, right would be 103 4 to 213 9
a circle: 30 -20 to 70 20
a mirrored circle: 30 -20 to 70 20, right would be -70 -20 to -30 20
a half circle as polyline: 0 0 to 40 0, right would be 0 -20 to 40 0
an ellipse: nothing, right would be 30 -10 to 70 10
END
