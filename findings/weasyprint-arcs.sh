#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# WeasyPrint 57.2 makes one cubic of an arc of half a circle in an SVG path, and draws it 2 % too wide between its ends: 20.4 for a radius
# of 20, so that bores drawn as two half circles are not round; <circle>, shorter and longer arcs are. Arrowheads made as markers are the
# whole box of the marker, filled. Nothing is said. Believed: as librsvg 2.54 does, 20.0 and a point.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages weasyprint=57.2-1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
# Debian's pyphen, which hyphenates texts, looks for its dictionaries in a folder of the system.
mkdir instead
printf 'LANGUAGES = {}\n\ndef language_fallback(language):\n    return None\n' >instead/pyphen.py
export PYTHONPATH=$work/instead:$work/root/usr/lib/python3/dist-packages
arrow='<marker id="a" viewBox="0 0 6 4" refX="6" refY="2" markerWidth="6" markerHeight="4" markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0 6 2 0 4z" fill="#000" stroke="none"/></marker>'
draw() {  # NAME WHAT ELEMENTS
  local svg='<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="60mm" viewBox="-30 -30 60 60" fill="none" stroke="#000" stroke-width="0.1">'$3'</svg>'
  echo "$svg" >"$1.svg"
  echo "<html><head><style>@page{size:60mm 60mm;margin:0}body{margin:0}svg{display:block}</style></head><body>$svg</body></html>" >"$1.html"
  /usr/bin/python3 -m weasyprint "$1.html" "$1-weasyprint.pdf" 2>/dev/null
  rsvg-convert -f pdf -b white -o "$1-librsvg.pdf" "$1.svg"
  local program
  for program in weasyprint librsvg; do
    pdftoppm -r 254 -gray -singlefile "$1-$program.pdf" "$1-$program"
    echo "$program, $2 $(python3 measure.py "$2" "$1-$program.pgm")"
  done
}
cat >measure.py <<'PY'
import math
import sys
data = open(sys.argv[2], "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
rows = data[len(data) - width * height :]
black = [((i % width + 0.5) / 10 - 30, (i // width + 0.5) / 10 - 30) for i in range(width * height) if rows[i] < 128]
if "arrow" in sys.argv[1]:
    tip = [y for x, y in black if 19.4 < x < 19.6]
    print(f"{max(tip) - min(tip):.1f} mm wide at 0.5 mm from its point")
else:
    radii = [math.hypot(x, y) for x, y in black]
    print(f"from {min(radii):.1f} to {max(radii):.1f}")
PY
{
  draw whole "circle of radius 20" '<circle r="20"/>'
  draw quarter "arc of 90" '<path d="M0 -20A20 20 0 0 1 20 0"/>'
  draw more "arc of 135" '<path d="M-20 0A20 20 0 0 1 14.1421 -14.1421"/>'
  draw half "arc of 180" '<path d="M-20 0A20 20 0 0 1 20 0"/>'
  draw three "arc of 270" '<path d="M0 -20A20 20 0 1 1 -20 0"/>'
  draw line "arrow" "$arrow"'<path d="M-20 0H20" marker-end="url(#a)"/>'
} >seen
expect_in seen <<'END'
weasyprint, circle of radius 20 from 20.0 to 20.2
librsvg, circle of radius 20 from 20.0 to 20.1
weasyprint, arc of 90 from 20.0 to 20.1
librsvg, arc of 90 from 20.0 to 20.1
weasyprint, arc of 135 from 20.0 to 20.1
librsvg, arc of 135 from 19.9 to 20.1
weasyprint, arc of 180 from 20.0 to 20.4
librsvg, arc of 180 from 20.0 to 20.1
weasyprint, arc of 270 from 20.0 to 20.1
librsvg, arc of 270 from 20.0 to 20.1
weasyprint, arrow 3.9 mm wide at 0.5 mm from its point
librsvg, arrow 0.3 mm wide at 0.5 mm from its point
END
