#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# MuPDF 1.21.1 (mutool) draws the dashed lines of an SVG as solid ones, so that hidden edges and centre lines look like visible edges; it
# draws what a clip path hides, and puts an inner svg at the origin. All without a word. Believed: as librsvg 2.54 does.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages mupdf-tools=1.21.1+ds2-1+deb12u1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
drawing() {  # NAME CONTENT
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\">$2</svg>" >"$1.svg"
}
line='fill="none" stroke="#000" stroke-width="2"'
drawing solid "<path d=\"M10 25H90\" $line/>"
drawing dashed "<path d=\"M10 25H90\" stroke-dasharray=\"8 8\" $line/>"
drawing clipped "<defs><clipPath id=\"c\"><path d=\"M10 0H30V50H10z\"/></clipPath></defs><path d=\"M0 25H100\" clip-path=\"url(#c)\" $line/>"
drawing inner "<svg x=\"30\" y=\"10\" width=\"40\" height=\"30\" viewBox=\"0 0 40 30\"><path d=\"M0 15H40\" $line/></svg>"
for name in solid dashed clipped inner; do
  mutool convert -o $name-mutool.pdf $name.svg 2>messages
  rsvg-convert -f pdf -o $name-librsvg.pdf $name.svg
  for program in librsvg mutool; do
    pdftoppm -r 254 -gray -singlefile $name-$program.pdf picture
    python3 - "$name, $program" <<'PY'
import sys
data = open("picture.pgm", "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
black = [(i % width, i // width) for i, pixel in enumerate(data[-width * height:]) if pixel < 128]
print(f"{sys.argv[1]}: {round(len(black) / 100)} mm2 black from x = {round(min(black)[0] / 10)} mm, "
      f"y = {round(min(y for x, y in black) / 10)} mm")
PY
  done
  grep . messages || true
done >seen
expect_in seen <<'END'
solid, librsvg: 160 mm2 black from x = 10 mm, y = 24 mm
solid, mutool: 160 mm2 black from x = 10 mm, y = 24 mm
dashed, librsvg: 80 mm2 black from x = 10 mm, y = 24 mm
dashed, mutool: 160 mm2 black from x = 10 mm, y = 24 mm
clipped, librsvg: 40 mm2 black from x = 10 mm, y = 24 mm
clipped, mutool: 200 mm2 black from x = 0 mm, y = 24 mm
inner, librsvg: 80 mm2 black from x = 30 mm, y = 24 mm
inner, mutool: 80 mm2 black from x = 0 mm, y = 14 mm
END
