#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# hp2xx 3.4.4 moves a plot to the left edge of the SVG that it writes, but not to its foot: whatever stands above the height 0 of the
# paper leaves the view box at the top, and from the plot's own height on the picture is empty, with success. Its EPS is right. Believed:
# all of the plot is inside.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages hp2xx=3.4.4-12+b1 ghostscript=10.0.0~dfsg-11+deb12u9
for foot in 0 1000 2000; do
  printf 'IN;SP1;PU4000,%d;PD6000,%d,6000,%d;PU;SP0;' $foot $foot $((foot + 2000)) >plot.plt
  hp2xx -q -t -c 14 -m svg -f plot.svg plot.plt
  hp2xx -q -t -c 14 -m eps -f plot.eps plot.plt
  python3 - $((foot / 40)) <<'PY'
import re, subprocess, sys
svg = open("plot.svg").read()
height = float(re.search(r'viewBox="0 0 \S+ (\S+)"', svg)[1])
ys = [float(y) for path in re.findall(r' d="([^"]+)"', svg) for y in re.findall(r", (\S+)", path)]
eps = subprocess.run(["gs", "-q", "-dBATCH", "-dNOPAUSE", "-sDEVICE=bbox", "plot.eps"], capture_output=True, text=True).stderr
low, high = (round(float(eps.split()[i])) for i in (2, 4))
print(f"foot at {sys.argv[1]} mm: SVG y {min(ys) + 0:.0f} to {max(ys) + 0:.0f} of 0 to {height:.0f}; EPS {low} to {high}")
PY
done >seen
expect_in seen <<'END'
foot at 0 mm: SVG y 0 to 142 of 0 to 142; EPS 0 to 143
foot at 25 mm: SVG y -71 to 71 of 0 to 142; EPS 0 to 143
foot at 50 mm: SVG y -142 to 0 of 0 to 142; EPS 0 to 143
END
