#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svgtoipe 20191210 (Debian's 7.2.24.1; SVG into Ipe, to go on drawing) makes hidden lines continuous (stroke-dasharray in any form) and draws what is
# hidden; a sheet of 200 mm becomes one of 200 pt, 71 mm; what is turned about a point is turned about the origin; round corners
# become square, and arcs whose radius is to be enlarged do not reach their end. It says nothing of these, though it does of what it
# cannot read. Other transforms, arcs and curves are right. Believed: as SVG 1.1 has them (7.6, 7.10, 9.2, 11.4, 11.5, F.6.6).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages svgtoipe=1:7.2.24.1-3.1
try() {  # NAME SHEET SHAPE
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" $2>$3</svg>" >drawing.svg
  svgtoipe drawing.svg drawing.ipe >messages 2>&1
  echo "$1: $(grep -oE 'paper="[^"]*"' drawing.ipe) $(sed -n '/<page>/,$p' drawing.ipe | sed 's/ stroke="0 0 0"//' | grep -vE '^<(/?page|/ipe|/group|/path|group matrix="1 0 0 -1 0 100")>' | paste -sd ' ')$(cat messages)"
}
points='width="200" height="100"'
{
  try "a line" "$points" '<path d="M10 50H60" stroke="black" fill="none"/>'
  try "a dashed line" "$points" '<path d="M10 50H60" stroke="black" fill="none" stroke-dasharray="4,2"/>'
  try "a line dashed by its style" "$points" '<path d="M10 50H60" style="stroke:black;fill:none;stroke-dasharray:4 2"/>'
  try "an invisible line" "$points" '<path d="M10 50H60" stroke="black" fill="none" visibility="hidden"/>'
  try "a line not to be displayed" "$points" '<path d="M10 50H60" stroke="black" fill="none" display="none"/>'
  try "a sheet in millimetres" 'width="200mm" height="100mm" viewBox="0 0 200 100"' '<path d="M10 50H60" stroke="black" fill="none"/>'
  try "a line turned about 10 50" "$points" '<path d="M10 50H60" stroke="black" fill="none" transform="rotate(90 10 50)"/>'
  try "a line moved, turned, moved back" "$points" '<path d="M10 50H60" stroke="black" fill="none" transform="translate(10 50) rotate(90) translate(-10 -50)"/>'
  try "a rectangle with round corners" "$points" '<rect x="10" y="10" width="30" height="20" rx="5" stroke="black" fill="none"/>'
  try "a half circle" "$points" '<path d="M0 50A25 25 0 0 0 50 50" stroke="black" fill="none"/>'
  try "a half circle by a smaller radius" "$points" '<path d="M0 50A20 20 0 0 0 50 50" stroke="black" fill="none"/>'
} >seen
expect_in seen <<'END'
a line: paper="200 100" <path> 10 50 m 60 50 l
a dashed line: paper="200 100" <path> 10 50 m 60 50 l
a line dashed by its style: paper="200 100" <path> 10 50 m 60 50 l
an invisible line: paper="200 100" <path> 10 50 m 60 50 l
a line not to be displayed: paper="200 100" <path> 10 50 m 60 50 l
a sheet in millimetres: paper="200 100" <path> 10 50 m 60 50 l
a line turned about 10 50: paper="200 100" <path matrix="6.12323e-17 1 -1 6.12323e-17 0 0"> 10 50 m 60 50 l
a line moved, turned, moved back: paper="200 100" <path matrix="6.12323e-17 1 -1 6.12323e-17 60 40"> 10 50 m 60 50 l
a rectangle with round corners: paper="200 100" <path> 10 10 m 40 10 l 40 30 l 10 30 l h
a half circle: paper="200 100" <path> 0 50 m 25 0 0 -25 25 50 50 50 a
a half circle by a smaller radius: paper="200 100" <path> 0 50 m 20 0 0 -20 25 50 50 50 a
END
