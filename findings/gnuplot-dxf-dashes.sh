#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gnuplot 5.4.4 (set terminal dxf) gives curves line types by their number: the first one is CONTINUOUS though it is to be dashed (dt 2), the second
# DASHED, though it is to be solid, and the axes HIDDEN. Widths (lw) are lost. Nothing is said. Its SVG has dashes and widths as asked. Believed: the line types of the plot.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages gnuplot-nox=5.4.4+dfsg1-2+b2
cat >plot.gp <<'GP'
set parametric
set samples 73
unset key
set xrange [-10:10]
set yrange [-10:10]
plot 10 * cos(t), 10 * sin(t) with lines dt 2 lw 1, 5 * cos(t), 5 * sin(t) with lines dt solid lw 4
GP
for kind in dxf svg; do gnuplot-nox -e "set terminal $kind; set output 'plot.$kind'" plot.gp; done
cat >read.py <<'PY'
import re

words = [line.strip() for line in open("plot.dxf").read().split("\n")]
things = []
for code, value in zip(words[::2], words[1::2]):
    if code == "0":
        things.append({"kind": value})
    elif things:
        things[-1].setdefault(code, value)
types = {}
for thing in things:
    if thing["kind"] == "POLYLINE":
        types.setdefault(thing["8"], set()).add(thing["6"] + (" with a width" if "40" in thing else " without a width"))
for layer, what in (("0", "first curve, dt 2 lw 1"), ("1", "second curve, dt solid lw 4"), ("2", "axes")):
    print(f"DXF, {what}: {', '.join(sorted(types[layer]))}")
for number, group in enumerate(open("plot.svg").read().split('id="gnuplot_plot_')[1:3], 1):
    curve = group[:group.index("<path") + 200].split("<path")[1].split(" d=")[0]
    widths = sorted(set(re.findall(r'stroke-width="([^"]*)"', group[:group.index("<path")])))
    print(f"SVG, curve {number}: {'dashed' if 'dasharray' in curve else 'solid'}, width {' or '.join(widths)}")
PY
python3 read.py >seen
expect_in seen <<'END'
DXF, first curve, dt 2 lw 1: CONTINUOUS without a width
DXF, second curve, dt solid lw 4: DASHED without a width
DXF, axes: HIDDEN without a width
SVG, curve 1: dashed, width 1.00
SVG, curve 2: solid, width 4.00
END
