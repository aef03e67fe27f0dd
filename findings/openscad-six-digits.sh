#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenSCAD 2021.01 writes DXF, SVG, STL and AMF with six digits of each number: a plate 10.4 mm wide that stands 123 m from the origin, as on
# the drawing of a site, becomes 11 mm wide, and a plate 0.2 mm thick there vanishes without a word.
# Believed: as many digits as a double has, or at least 0.001 mm.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openscad=2021.01-6
export HOME=$work
echo 'translate([123456.3, 0]) square([10.4, 5]);' >flat.scad
echo 'translate([123456.1, 0, 0]) cube([0.2, 5, 5]); translate([123470.3, 0, 0]) cube([10.4, 5, 5]);' >solid.scad
for format in dxf svg; do openscad -o flat.$format flat.scad 2>/dev/null; done
for format in stl amf; do openscad -o solid.$format solid.scad 2>messages; done
{
  echo "asked: 123456.3 to 123466.7"
  echo "DXF:" "$(awk '{ gsub(/[ \r]/, "") } section == "ENTITIES" && NR % 2 == 0 && (code == 10 || code == 11) { print } NR % 2 == 0 && code == 2 { section = $0 } { code = $0 }' flat.dxf | sort -nu | xargs)"
  echo "SVG:" "$(grep -oE '[ML] [0-9]+[0-9.]*' flat.svg | cut -c3- | sort -nu | xargs)"
  echo "asked: 123456.1 to 123456.3, and 123470.3 to 123480.7"
  echo "STL:" "$(awk '/vertex/ { print $2 }' solid.stl | sort -nu | xargs)"
  echo "AMF:" "$(grep -oE '<x>[0-9.]*' solid.amf | cut -c4- | sort -nu | xargs)"
} >seen
expect_in seen <<'END'
asked: 123456.3 to 123466.7
DXF: 123456 123467
SVG: 123456 123467
asked: 123456.1 to 123456.3, and 123470.3 to 123480.7
STL: 123456 123470 123481
AMF: 123456 123470 123481
END
