#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gnuplot 5.4.4 writes HP-GL that scales (SC 0,10000,0,7500) to whatever sheet the plotter has. hp2xx 3.4.4 takes that for an upright A0
# sheet, and a circle comes out as an ellipse of 620 x 1169 mm. Believed: a circle, perhaps of another size; gnuplot's own DXF has one, and
# so has hp2xx as soon as the file says where the corners lie (IP).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages gnuplot-nox=5.4.4+dfsg1-2+b2 hp2xx=3.4.4-12+b1
plot() {  # TERMINAL FILE
  gnuplot-nox <<GP
set terminal $1
set output '$2'
set size ratio -1
unset border; unset xtics; unset ytics; unset key
set parametric
set trange [0:2*pi]; set xrange [-1:1]; set yrange [-1:1]
set samples 400
plot cos(t), sin(t)
GP
}
plot dxf gnuplot.dxf
plot hpgl circle.plt
hp2xx -q -t -c 14 -m dxf -f hp2xx.dxf circle.plt 2>/dev/null
sed 's/^SC/IP0,0,10000,7500;\nSC/' circle.plt >corners.plt
hp2xx -q -t -c 14 -m dxf -f corners.dxf corners.plt 2>/dev/null
{
  grep -oE '^(SC|IP)[^;]*' circle.plt
  for name in gnuplot hp2xx corners; do
    python3 - $name <<'PY'
import sys
words = [word.strip() for word in open(sys.argv[1] + ".dxf")]
pairs = list(zip(words[::2], words[1::2]))
pairs = pairs[pairs.index(("2", "ENTITIES")):]
wide, high = (max(values) - min(values) for values in ([float(value) for code, value in pairs if code in codes]
                                                       for codes in (("10", "11"), ("20", "21"))))
print(f"{sys.argv[1]}: {wide:.0f} x {high:.0f}")
PY
  done
} >seen
expect_in seen <<'END'
SC0,10000,0,7500
gnuplot: 75 x 75
hp2xx: 620 x 1169
corners: 184 x 184
END
