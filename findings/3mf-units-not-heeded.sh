#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A 3MF in inches with a box of 10 is 10 mm wide in OpenSCAD 2021.01 (which works in mm) and 10 in assimp 5.2.5, whose scene tells no
# unit; one in microns is 10, too. Believed: a format whose model states its unit is scaled by every reader.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openscad=2021.01-6 assimp-utils=5.2.5~ds0-1+b1
for unit in millimeter inch micron; do
  model_3mf "$unit" "$(object_3mf 1 model)" '<item objectid="1"/>' | pack_3mf "$unit.3mf"
  echo "import(\"$unit.3mf\");" >"$unit.scad"
  openscad -o "$unit.off" "$unit.scad" 2>/dev/null
  echo "$unit: OpenSCAD $(extent "$unit.off"); assimp up to $(assimp info "$unit.3mf" | grep -oP 'Maximum point +\(\K[0-9.]+')"
done >seen
expect_in seen <<'END'
millimeter: OpenSCAD 0..10 0..10 0..10; assimp up to 10.000000
inch: OpenSCAD 0..10 0..10 0..10; assimp up to 10.000000
micron: OpenSCAD 0..10 0..10 0..10; assimp up to 10.000000
END
