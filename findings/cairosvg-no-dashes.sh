#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# CairoSVG 2.5.2: stroke-dasharray="none" does not take a line out of the dashes of its group; it is drawn dashed, visible edges like
# hidden ones. Believed: solid, as librsvg 2.54 draws it.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-cairosvg=2.5.2-1.1+deb12u1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >lines.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="50mm" viewBox="0 0 100 50">
<g stroke="#000" stroke-width="2" stroke-dasharray="8 8"><path d="M10 10H90"/><path d="M10 40H90" stroke-dasharray="none"/></g></svg>
SVG
rsvg-convert -f pdf -o librsvg.pdf lines.svg
python3 -m cairosvg lines.svg -o cairosvg.pdf
for program in librsvg cairosvg; do
  pdftoppm -r 254 -gray -singlefile $program.pdf picture
  python3 - $program <<'PY'
import sys
data = open("picture.pgm", "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
pixels = data[-width * height:]
half = width * (height // 2)
above, below = (round(sum(pixel < 128 for pixel in part) / 100) for part in (pixels[:half], pixels[half:]))
print(f"{sys.argv[1]}: dashed {above} mm2, not dashed {below} mm2")
PY
done >seen
expect_in seen <<'END'
librsvg: dashed 80 mm2, not dashed 160 mm2
cairosvg: dashed 80 mm2, not dashed 80 mm2
END
