#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# PrusaSlicer 2.5.0 takes each place of a 3MF apart into a turn and three scales, which none has that slants the body, as where an assembly scales a
# turned part along one axis: a box of 1000 mm3 sheared by its height has 1414 and is 14.1 mm high, one turned and then stretched to 2000 has 2500
# and another box. Nothing is said, and it is printed so. Turns, mirrors and scales along the box are right. Believed: corners
# are moved by the matrix (3MF core, 3.3 and 4.1.1).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages prusa-slicer=2.5.0+dfsg-4
export HOME=$work
size() {  # WHAT RIGHT TRANSFORM
  model_3mf millimeter "$(object_3mf 1 model)" "<item objectid=\"1\" transform=\"$3 0 0 0\"/>" | pack_3mf place.3mf
  prusa-slicer --info place.3mf 2>/dev/null >info
  awk -F ' = ' -v what="$1" -v right="$2" '{ value[$1] = $2 } END { printf "%s: %.1f x %.1f x %.1f mm, %.0f mm3; right would be %s\n", what, value["size_x"], value["size_y"], value["size_z"], value["volume"], right }' info
}
{
  size "turned by 90 degrees" "10.0 x 10.0 x 10.0 mm, 1000 mm3" "0 1 0 -1 0 0 0 0 1"
  size "mirrored" "10.0 x 10.0 x 10.0 mm, 1000 mm3" "-1 0 0 0 1 0 0 0 1"
  size "stretched" "20.0 x 10.0 x 10.0 mm, 2000 mm3" "2 0 0 0 1 0 0 0 1"
  size "sheared" "20.0 x 10.0 x 10.0 mm, 1000 mm3" "1 0 0 0 1 0 1 0 1"
  size "turned by 45 degrees, then stretched" "28.3 x 10.0 x 14.1 mm, 2000 mm3" "1.41421356 0 -0.70710678 0 1 0 1.41421356 0 0.70710678"
} >seen
expect_in seen <<'END'
turned by 90 degrees: 10.0 x 10.0 x 10.0 mm, 1000 mm3; right would be 10.0 x 10.0 x 10.0 mm, 1000 mm3
mirrored: 10.0 x 10.0 x 10.0 mm, 1000 mm3; right would be 10.0 x 10.0 x 10.0 mm, 1000 mm3
stretched: 20.0 x 10.0 x 10.0 mm, 2000 mm3; right would be 20.0 x 10.0 x 10.0 mm, 2000 mm3
sheared: 10.0 x 10.0 x 14.1 mm, 1414 mm3; right would be 20.0 x 10.0 x 10.0 mm, 1000 mm3
turned by 45 degrees, then stretched: 21.2 x 10.0 x 21.2 mm, 2500 mm3; right would be 28.3 x 10.0 x 14.1 mm, 2000 mm3
END
