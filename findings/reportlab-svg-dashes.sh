#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# reportlab 3.6.12 (graphics.renderSVG) writes each line as a path that is closed, thus drawn to its end and back: what is dashed has its gaps
# filled on the way back, unless the length happens to let dashes meet dashes: with dashes of 4 and gaps of 2, lines of 90 and 91 are
# continuous, of 89 and 92 dashed. Its PDF of the same drawing is right. Believed: the same dashes.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-reportlab=3.6.12-1+deb12u1 python3-renderpm=3.6.12-1+deb12u1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >draw.py <<'PY'
from reportlab.graphics import renderPDF, renderSVG
from reportlab.graphics.shapes import Drawing, Line

for length in (89, 90, 91, 92):
    drawing = Drawing(120, 20)
    drawing.add(Line(10, 10, 10 + length, 10, strokeDashArray=[4, 2], strokeWidth=1))
    with open(f"{length}.svg", "w") as file:
        file.write(renderSVG.drawToString(drawing))
    renderPDF.drawToFile(drawing, f"{length}.own.pdf")
PY
cat >count.py <<'PY'
import sys
with open(sys.argv[1], "rb") as file:
    file.readline()
    width, height = map(int, file.readline().split())
    file.readline()
    row = file.read()[width * (height // 2):][:width]
print(f"{sum(pixel < 128 for pixel in row) / 10:.0f}")  # ten pixels a point
PY
/usr/bin/python3 draw.py
for length in 89 90 91 92; do
  rsvg-convert -f pdf --dpi-x 72 --dpi-y 72 $length.svg >$length.svg.pdf
  for kind in own svg; do pdftoppm -gray -r 720 -singlefile $length.$kind.pdf $length.$kind; done
  echo "line of $length, dashes 4, gaps 2: drawn $(python3 count.py $length.own.pgm) in PDF, $(python3 count.py $length.svg.pgm) in SVG"
done >seen
grep -o '<path d="[^"]*"' 90.svg >>seen
expect_in seen <<'END'
line of 89, dashes 4, gaps 2: drawn 60 in PDF, 60 in SVG
line of 90, dashes 4, gaps 2: drawn 60 in PDF, 90 in SVG
line of 91, dashes 4, gaps 2: drawn 61 in PDF, 91 in SVG
line of 92, dashes 4, gaps 2: drawn 62 in PDF, 62 in SVG
<path d="M 10,10 L 100,10 Z"
END
