#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg.path 6.1 (Python) writes the H of an SVG path with two numbers, "H 30,20", which are two horizontal lines: to 30, and back to 20 (SVG 1.1,
# 8.3.4). A rectangle from 10, 20 that was read and written has lines inside and a slanted side; it is 126.1 long instead of 80, as svg.path
# itself reads it. With relative h the second number is 0, a line of no length. V is right. Nothing is said. Believed: what d() gives is the
# path that was read.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-svg.path=6.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >write.py <<'PY'
from svg.path import parse_path

for read in ("M10 20H30V40H10Z", "m10 20h20v20h-20z", "M10 20V40", "M10 20L30 20L30 40L10 40Z"):
    path = parse_path(read)
    print(f"{read}: {path.d()}, {path.length():.1f} long, then {parse_path(path.d()).length():.1f}")
PY
python3 write.py >seen
expect_in seen <<'END'
M10 20H30V40H10Z: M 10,20 H 30,20 V 40 H 10,40 Z, 80.0 long, then 126.1
m10 20h20v20h-20z: m 10,20 h 20,0 v 20 h -20,0 z, 80.0 long, then 80.0
M10 20V40: M 10,20 V 40, 20.0 long, then 20.0
M10 20L30 20L30 40L10 40Z: M 10,20 L 30,20 L 30,40 L 10,40 Z, 80.0 long, then 80.0
END
