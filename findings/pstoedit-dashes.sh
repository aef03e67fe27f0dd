#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pstoedit 3.78 writes hidden lines (dashes of PostScript and PDF) as continuous ones into DXF, without a line type, and into HP-GL;
# its HP-GL gives pens of 0.5 mm as PW1.41732, which are millimetres in HP-GL/2: lines are 2.8 times too wide. Its FIG and SVG
# (plot-svg) have dashes. Nothing is said. Believed: LTYPE and LT, which both formats have.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages pstoedit=3.78-2 ghostscript=10.0.0~dfsg-11+deb12u9
export GS_LIB=$work/root/usr/share/ghostscript/10.00.0/Resource/Init:$work/root/usr/share/ghostscript/10.00.0/lib
cat >lines.ps <<'PS'
%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 0 0 283 283
%%EndComments
72 25.4 div dup scale 0.5 setlinewidth
10 10 moveto 90 10 lineto stroke
[3 2] 0 setdash 10 20 moveto 90 20 lineto stroke
showpage
PS
for format in fig dxf hpgl; do
  pstoedit -f $format lines.ps lines.$format 2>messages || { cat messages >&2; exit 1; }
  grep -iE 'dash|line style' messages || true
done
python3 - >seen <<'PY'
import re
fig = re.findall(r"^2 1 (\d)", open("lines.fig").read(), re.M)
print("FIG: line styles", *fig)
tags = open("lines.dxf").read().split("\n")
pairs = list(zip((tag.strip() for tag in tags[::2]), (tag.strip() for tag in tags[1::2])))
begin = pairs.index(("2", "ENTITIES"))
entities = [value for code, value in pairs[begin:] if code == "0" and value in ("POLYLINE", "LINE")]
print(f"DXF: {len(entities)} lines, {sum(code == '6' for code, _ in pairs[begin:])} with a line type, {len({v for c, v in pairs[begin:] if c == '8'})} layer")
text = open("lines.hpgl").read()
print("HP-GL: line types", *re.findall(r"LT[^;]*", text), "widths", *re.findall(r"PW([^;]*)", text), "lines", len(re.findall(r"PD", text)))
PY
expect_in seen <<'END'
FIG: line styles 0 1
DXF: 2 lines, 0 with a line type, 1 layer
HP-GL: line types LT widths 1.41732 1.41732 lines 2
END
