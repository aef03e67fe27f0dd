#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gmsh 4.8.4 writes faces that a Boolean difference leaves of its tool into STL inside out: the floor of a pocket of 1500 mm3 in a box of
# 24000 mm3, whose facets then enclose 22167 mm3, and all walls of a closed cavity of 1000 mm3, which then adds to the box. A reader that
# goes by the facets hatches the cavity. Believed: 22500 and 23000, every facet turned from the material.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages gmsh=4.8.4+ds2-3
for kind in pocket cavity; do
  [ $kind = cavity ] && height=10 || height=30
  cat >$kind.geo <<GEO
SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 40, 30, 20};
Box(2) = {15, 10, 5, 10, 10, $height};
BooleanDifference{ Volume{1}; Delete; }{ Volume{2}; Delete; }
GEO
  gmsh -2 -v 1 -format stl -o $kind.stl $kind.geo >/dev/null
  python3 - $kind <<'PY'
import sys
volume, corners = 0, []
for line in open(sys.argv[1] + ".stl"):
    if line.split()[:1] == ["vertex"]:
        corners.append([float(word) for word in line.split()[1:]])
    if len(corners) == 3:
        (a, b, c), corners = corners, []
        volume += sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3)) / 6
print(f"{sys.argv[1]}: {volume:.0f} mm3")
PY
done >seen
expect_in seen <<'END'
pocket: 22167 mm3
cavity: 25000 mm3
END
