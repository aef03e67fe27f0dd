#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# GraphicsMagick 1.3.40 draws what an SVG hides (display, visibility), turns about the origin whatever centre a rotation names, and leaves out
# lines after z. It ends with success. Hidden parts of a drawing appear, and what is turned about a point stands elsewhere. Believed: as
# librsvg 2.54.7.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages graphicsmagick=1.4+really1.3.40-4+deb12u1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
box() {  # FILE of PPM: the box of what is dark
  python3 - "$1" <<'PY'
import sys
with open(sys.argv[1], "rb") as file:
    assert file.readline().startswith(b"P6")
    width, height = map(int, file.readline().split())
    file.readline()
    pixels = file.read()
dark = [(i % width, i // width) for i in range(width * height) if pixels[3 * i] < 128]
print(" ".join(f"{min(axis)}..{max(axis) + 1}" for axis in zip(*dark)) or "nothing")
PY
}
drawn() {  # NAME ELEMENT: on a sheet of 100 x 100
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100' viewBox='0 0 100 100'><g stroke='black' stroke-width='4' fill='none'>$2</g></svg>" >sheet.svg
  rsvg-convert -b white -f pdf --dpi-x 72 --dpi-y 72 sheet.svg -o sheet.pdf
  pdftoppm -r 72 -singlefile sheet.pdf right
  gm convert -background white sheet.svg -depth 8 ppm:seen.ppm 2>messages || echo failed
  echo "$1: librsvg $(box right.ppm), GraphicsMagick $(box seen.ppm)"
}
{
  drawn "line" '<path d="M10 50H90"/>'
  drawn "moved and turned" '<path d="M0 0H40" transform="translate(50 50) rotate(90)"/>'
  drawn "turned about 50 50" '<path d="M10 50H90" transform="rotate(90 50 50)"/>'
  drawn "from beyond the sheet, turned about 50 50" '<path d="M10 -50H90" transform="rotate(90 50 50)"/>'
  drawn "line after z" '<path d="M50 50h20v20zl-30 -30"/>'
  drawn "display none" '<g display="none"><path d="M10 50H90"/></g>'
  drawn "visibility hidden" '<path d="M10 50H90" visibility="hidden"/>'
} >seen
expect_in seen <<'END'
line: librsvg 10..90 48..52, GraphicsMagick 10..91 48..53
moved and turned: librsvg 48..52 50..90, GraphicsMagick 48..53 50..91
turned about 50 50: librsvg 48..52 10..90, GraphicsMagick nothing
from beyond the sheet, turned about 50 50: librsvg nothing, GraphicsMagick 48..53 10..91
line after z: librsvg 19..72 19..74, GraphicsMagick 48..73 48..73
display none: librsvg nothing, GraphicsMagick 10..91 48..53
visibility hidden: librsvg nothing, GraphicsMagick 10..91 48..53
END
