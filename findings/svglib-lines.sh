#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svglib 1.4.1 (SVG into ReportLab's PDF): hidden lines (visibility="hidden") are drawn, arrowheads made as markers are lost, symbols
# ignore their viewBox and size, and dashes begin at 0 whatever the dash offset. Believed: as librsvg 2.54 does.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-svglib=1.4.1+dfsg-1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
drawing() {  # NAME CONTENT
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\">$2</svg>" >"$1.svg"
}
line='fill="none" stroke="#000" stroke-width="2"'
drawing plain "<path d=\"M10 25H90\" $line/>"
drawing visibility "<path d=\"M10 25H50\" $line/><path d=\"M50 25H90\" visibility=\"hidden\" $line/>"
drawing marker "<defs><marker id=\"m\" markerWidth=\"4\" markerHeight=\"4\" refY=\"2\" orient=\"auto\"><path d=\"M0 0L4 2L0 4z\"/></marker></defs><path d=\"M10 25H80\" marker-end=\"url(#m)\" $line/>"
drawing symbol "<symbol id=\"s\" viewBox=\"0 0 10 10\"><path d=\"M0 5H10\" $line/></symbol><use href=\"#s\" x=\"10\" y=\"15\" width=\"20\" height=\"20\"/>"
drawing offset "<path d=\"M10 25H90\" stroke-dasharray=\"16 16\" stroke-dashoffset=\"16\" $line/>"
cat >convert.py <<'PY'
import sys
from reportlab.graphics import renderPDF
from svglib.svglib import svg2rlg
renderPDF.drawToFile(svg2rlg(sys.argv[1]), sys.argv[2])
PY
for name in plain visibility marker symbol offset; do
  rsvg-convert -f pdf -o librsvg.pdf $name.svg
  python3 convert.py $name.svg svglib.pdf 2>messages || { cat messages >&2; exit 1; }
  for program in librsvg svglib; do
    pdftoppm -r 254 -gray -singlefile $program.pdf picture
    python3 - "$name, $program" <<'PY'
import sys
data = open("picture.pgm", "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
black = [i % width for i, pixel in enumerate(data[-width * height:]) if pixel < 128]
print(f"{sys.argv[1]}: {round(len(black) / 100)} mm2 black, x = {round(min(black) / 10)} to {round(max(black) / 10)} mm")
PY
  done
done >seen
expect_in seen <<'END'
plain, librsvg: 160 mm2 black, x = 10 to 90 mm
plain, svglib: 160 mm2 black, x = 10 to 90 mm
visibility, librsvg: 80 mm2 black, x = 10 to 50 mm
visibility, svglib: 160 mm2 black, x = 10 to 90 mm
marker, librsvg: 172 mm2 black, x = 10 to 88 mm
marker, svglib: 140 mm2 black, x = 10 to 80 mm
symbol, librsvg: 80 mm2 black, x = 10 to 30 mm
symbol, svglib: 20 mm2 black, x = 10 to 20 mm
offset, librsvg: 64 mm2 black, x = 26 to 74 mm
offset, svglib: 96 mm2 black, x = 10 to 90 mm
END
