#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenSCAD 2021.01 reads the objects of a 3MF and not its build: a box built at x = 100, and again at double width at x = -50, is one box
# at the origin. No warning. Believed: the build is what is imported.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openscad=2021.01-6
model_3mf millimeter "$(object_3mf 1 model)" \
  '<item objectid="1" transform="1 0 0 0 1 0 0 0 1 100 0 0"/><item objectid="1" transform="2 0 0 0 1 0 0 0 1 -50 0 0"/>' | pack_3mf built.3mf
echo 'import("built.3mf");' >built.scad
openscad -o built.off built.scad 2>log
{ echo "$(extent built.off), $(grep -ci warning log || true) warnings"; } >seen
expect_in seen <<'END'
0..10 0..10 0..10, 0 warnings
END
