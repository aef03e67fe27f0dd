#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Inkscape 1.2.2 leaves polylines and polygons out of the DXF R14 that it makes of an SVG, and all but paths out of its DXF R12: lines,
# rectangles and circles, too. Both have what is hidden, R12 also what only stands in definitions, such as arrowheads, at the origin.
# It ends with success and names none of it (what R14 takes is told in the help of its dialogue). Paths are right. Believed: all that is drawn.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages inkscape=1.2.2-2+deb12u1 python3-cssselect=1.2.0-2 python3-lxml=4.9.2-1+deb12u1 python3-numpy=1:1.24.2-1+deb12u1
export HOME=$work INKSCAPE_DATADIR=$work/root/usr/share XDG_DATA_DIRS=$work/root/usr/share PYTHONPATH=$work/root/usr/lib/python3/dist-packages
export LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$work/root/usr/lib/x86_64-linux-gnu/inkscape
draw() {  # WHAT RIGHT CONTENT
  printf '<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50"><g fill="none" stroke="#000">%s</g></svg>' "$3" >sheet.svg
  rm -f r12.dxf r14.dxf
  inkscape sheet.svg --export-extension=org.inkscape.output.dxf_twelve -o r12.dxf >messages 2>&1
  inkscape sheet.svg --export-extension=org.ekips.output.dxf_outlines -o r14.dxf >>messages 2>&1
  echo "$1: R12 $(grep -c '^ *LINE' r12.dxf || true), R14 $(grep -cE '^(LINE|SPLINE|LWPOLYLINE)' r14.dxf || true) entities; right would be $2"
}
{
  draw "path" "2 lines, or 1 polyline" '<path d="M10 10H50V30"/>'
  draw "line" "1" '<line x1="10" y1="10" x2="50" y2="10"/>'
  draw "rectangle" "4 lines, or 1 polyline" '<rect x="10" y="10" width="30" height="20"/>'
  draw "circle" "some lines or splines" '<circle cx="30" cy="20" r="10"/>'
  draw "polyline" "2 lines, or 1 polyline" '<polyline points="10,10 50,10 50,30"/>'
  draw "polygon" "3 lines, or 1 polyline" '<polygon points="10,10 50,10 50,30"/>'
  draw "hidden path" "0" '<path d="M10 10H50" display="none"/>'
  draw "arrowhead that nothing has" "0" '<defs><marker id="arrow"><path d="M0 0L4 2"/></marker></defs>'
} >seen
expect_in seen <<'END'
path: R12 2, R14 1 entities; right would be 2 lines, or 1 polyline
line: R12 0, R14 1 entities; right would be 1
rectangle: R12 0, R14 1 entities; right would be 4 lines, or 1 polyline
circle: R12 0, R14 7 entities; right would be some lines or splines
polyline: R12 0, R14 0 entities; right would be 2 lines, or 1 polyline
polygon: R12 0, R14 0 entities; right would be 3 lines, or 1 polyline
hidden path: R12 1, R14 1 entities; right would be 0
arrowhead that nothing has: R12 1, R14 0 entities; right would be 0
END
