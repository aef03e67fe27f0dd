#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pstoedit 3.78 turns the curves of PostScript and PDF into X-splines of FIG through a few points: a circle of radius 20 becomes a wavy one,
# 19.75 to 20.10 as fig2dev 3.2.8b draws it. Nothing is said. Believed: curves are kept to the unit of
# the file, 1/1200 in.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages pstoedit=3.78-2 fig2dev=1:3.2.8b-3+deb12u2 ghostscript=10.0.0~dfsg-11+deb12u9
export GS_LIB=$work/root/usr/share/ghostscript/10.00.0/Resource/Init:$work/root/usr/share/ghostscript/10.00.0/lib
cat >circle.ps <<'PS'
%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 0 0 283 283
%%EndComments
72 25.4 div dup scale 0.5 setlinewidth
50 50 20 0 360 arc closepath stroke
showpage
PS
pstoedit -f fig circle.ps circle.fig 2>messages || { cat messages >&2; exit 1; }
fig2dev -L svg circle.fig circle.svg
python3 - >seen <<'PY'
import math, re
points = [tuple(map(int, point.split(","))) for point in re.search(r'points="([^"]*)"', open("circle.svg").read())[1].split()]
sides = [[limit(point[i] for point in points) for limit in (min, max)] for i in (0, 1)]
centre = [sum(side) / 2 for side in sides]
radii = [math.dist(point, centre) * 25.4 / 1200 for point in points]
spline = re.search(r"^3 (\d) ", open("circle.fig").read(), re.M)
print("X-spline" if spline and spline[1] in "45" else "other")
print(f"radius 20 mm: {min(radii):.2f} to {max(radii):.2f}")
PY
expect_in seen <<'END'
X-spline
radius 20 mm: 19.75 to 20.10
END
