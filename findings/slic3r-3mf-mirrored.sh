#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Slic3r 1.3.0 takes the place of an item or component of a 3MF apart into three turns and three scales, of which no mirror is made: a box of
# 10 x 20 x 30 mm that is mirrored along one axis, as CAD programs write the left one of a pair, is printed askew, on a corner. It ignores the unit of
# the model: 10 inches are 10 mm. Nothing is said. Turns and scales are right. Believed: corners are moved by the matrix, and lengths in the
# unit (3MF core, 3.3, 3.4 and 4.1.1).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages slic3r=1.3.0+dfsg1-5+b2
export HOME=$work PERL5LIB=$work/root/usr/lib/slic3r:$work/root/usr/share/perl5:$work/root/usr/lib/x86_64-linux-gnu/perl5/5.36
box=$(object_3mf 1 model | sed 's/y="10"/y="20"/g; s/z="10"/z="30"/g')
size() {  # WHAT RIGHT UNIT OBJECTS ITEM
  model_3mf "$3" "$4" "$5" | pack_3mf box.3mf
  slic3r box.3mf --output box.gcode --skirts 0 --perimeters 1 --fill-density 0 --top-solid-layers 0 --bottom-solid-layers 0 --layer-height 0.3 \
    --first-layer-height 0.3 --nozzle-diameter 0.5 --extrusion-width 0.5 --first-layer-extrusion-width 0.5 >messages 2>&1 || cat messages >&2
  awk -v what="$1" -v right="$2" '/^G1/ { for (i = 2; i <= NF; ++i) at[substr($i, 1, 1)] = substr($i, 2) + 0 }
    /^G1 X.* E/ { if (!n++) { x1 = x2 = at["X"]; y1 = y2 = at["Y"] }
      if (at["X"] < x1) x1 = at["X"]; if (at["X"] > x2) x2 = at["X"]; if (at["Y"] < y1) y1 = at["Y"]; if (at["Y"] > y2) y2 = at["Y"]; if (at["Z"] > z) z = at["Z"] }
    END { seen = sprintf("%.0f x %.0f x %.0f mm", x2 - x1 + 0.5, y2 - y1 + 0.5, z); print what ": " seen (seen == right ? "" : ", right would be " right) }' box.gcode
}
item() { printf '<item objectid="%s" transform="%s 0 0 0"/>' "$1" "$2"; }
same="1 0 0 0 1 0 0 0 1" mirror="-1 0 0 0 1 0 0 0 1"
{
  size "as it is" "10 x 20 x 30 mm" millimeter "$box" "$(item 1 "$same")"
  size "turned about z" "20 x 10 x 30 mm" millimeter "$box" "$(item 1 "0 1 0 -1 0 0 0 0 1")"
  size "twice as long along x" "20 x 20 x 30 mm" millimeter "$box" "$(item 1 "2 0 0 0 1 0 0 0 1")"
  size "mirrored along x" "10 x 20 x 30 mm" millimeter "$box" "$(item 1 "$mirror")"
  size "mirrored as a component" "10 x 20 x 30 mm" millimeter \
    "$box<object id=\"2\" type=\"model\"><components><component objectid=\"1\" transform=\"$mirror 0 0 0\"/></components></object>" "$(item 2 "$same")"
  size "in centimetres" "100 x 200 x 300 mm" centimeter "$box" "$(item 1 "$same")"
  size "in inches" "254 x 508 x 762 mm" inch "$box" "$(item 1 "$same")"
} >seen
expect_in seen <<'END'
as it is: 10 x 20 x 30 mm
turned about z: 20 x 10 x 30 mm
twice as long along x: 20 x 20 x 30 mm
mirrored along x: 30 x 35 x 16 mm, right would be 10 x 20 x 30 mm
mirrored as a component: 30 x 35 x 22 mm, right would be 10 x 20 x 30 mm
in centimetres: 10 x 20 x 30 mm, right would be 100 x 200 x 300 mm
in inches: 10 x 20 x 30 mm, right would be 254 x 508 x 762 mm
END
