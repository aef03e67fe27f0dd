#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pstoedit 3.78 writes G-code in which a point is 0.0139 in, not 1/72: parts come 0.08 % too large, 1 m as 1000.8 mm. Dashed lines are
# cut whole, circles of 40 mm as 28 chords whose middles lie 0.13 mm inside. Believed: sizes are kept to the digits written.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages pstoedit=3.78-2 ghostscript=10.0.0~dfsg-11+deb12u9
export GS_LIB=$work/root/usr/share/ghostscript/10.00.0/Resource/Init:$work/root/usr/share/ghostscript/10.00.0/lib
cat >plate.ps <<'PS'
%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 0 0 2880 300
%%EndComments
72 25.4 div dup scale 0.5 setlinewidth
0 10 moveto 1000 10 lineto stroke
[3 2] 0 setdash 0 20 moveto 100 20 lineto stroke [] 0 setdash
100 60 20 0 360 arc closepath stroke
showpage
PS
pstoedit -f gcode plate.ps plate.ngc 2>messages || { cat messages >&2; exit 1; }
python3 - >seen <<'PY'
import math, re
lines = open("plate.ngc", errors="replace").read().split("\n")
factor = {name: float(value) for name, value in re.findall(r"#(\d+) = ([-0-9.]+)", "\n".join(lines))}
cuts = []
for line in lines:
    move = re.match(r" *G0([01]) X\[#(\d+)\*([-\d.e]+)\] Y\[#(\d+)\*([-\d.e]+)\]", line)
    if move:
        place = tuple(25.4 * factor[move[i]] * float(move[i + 1]) for i in (2, 4))
        cuts = cuts + [[place]] if move[1] == "0" else cuts[:-1] + [cuts[-1] + [place]]
straight, dashed, circle = cuts[0], cuts[1:-1], cuts[-1]
print("in inches" if any(line.startswith("G20") for line in lines) else "in mm")
print(f"1000 mm: {math.dist(*straight):.2f}")
print(f"dashed: {len(dashed)} cut of {math.dist(*dashed[0]):.2f} mm")
low, high = min(x for x, _ in circle), max(x for x, _ in circle)
centre, step = ((low + high) / 2, 60 * factor["1004"] * 72), list(zip(circle, circle[1:]))
middle = [math.dist(centre, ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)) for a, b in step if math.dist(a, b) > 0.01]
print(f"circle of 40 mm: {high - low:.2f} wide, {len(middle)} chords, the middle of one at {min(middle):.2f} of 20 mm")
PY
expect_in seen <<'END'
in inches
1000 mm: 1000.80
dashed: 1 cut of 100.08 mm
circle of 40 mm: 40.03 wide, 28 chords, the middle of one at 19.88 of 20 mm
END
