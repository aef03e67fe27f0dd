#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenSCAD 2021.01 imports of an SVG other parts than are seen: what is hidden (display none, visibility hidden), templates (symbol,
# pattern) and what a clip path cuts off become part of the model; copies by use and shapes whose lengths have units (width="20px")
# are left out. Nothing is said. Believed: what is seen, at least for fills.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openscad=2021.01-6 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
first='<path d="M10 10H30V20H10Z"/>'
second='<path d="M60 10H80V20H60Z"/>'
drawing() {  # NAME CONTENT
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\">$first$2</svg>" >"$1.svg"
}
drawing 'plain' "$second"
drawing 'display none' "<g display=\"none\">$second</g>"
drawing 'visibility hidden' "<g visibility=\"hidden\">$second</g>"
drawing 'symbol' "<symbol id=\"s\">$second</symbol>"
drawing 'pattern' "<pattern id=\"p\" width=\"9\" height=\"9\">$second</pattern>"
drawing 'clipped' "<clipPath id=\"c\"><path d=\"M60 10H70V20H60Z\"/></clipPath><g clip-path=\"url(#c)\">$second</g>"
drawing 'use' "<defs><path id=\"a\" d=\"M0 0H20V10H0Z\"/></defs><use xlink:href=\"#a\" x=\"60\" y=\"10\"/>"
drawing 'lengths in px' '<rect x="60px" y="10px" width="20px" height="10px"/>'
for name in 'plain' 'display none' 'visibility hidden' 'symbol' 'pattern' 'clipped' 'use' 'lengths in px'; do
  echo "linear_extrude(1) import(\"$name.svg\");" >model.scad
  openscad -o model.stl model.scad 2>messages || { cat messages >&2; exit 1; }
  rsvg-convert -f pdf -o seen.pdf "$name.svg"
  pdftoppm -r 254 -gray -singlefile seen.pdf picture
  python3 - "$name" "$(grep -ciE 'warning|error' messages || true)" <<'PY'
import re, sys
data = open("picture.pgm", "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
black = sum(pixel < 128 for pixel in data[-width * height:])
corners = [tuple(map(float, corner)) for corner in re.findall(r"vertex (\S+) (\S+) (\S+)", open("model.stl").read())]
volume = 0
for a, b, c in zip(corners[::3], corners[1::3], corners[2::3]):
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
print(f"{sys.argv[1]}: seen {round(black / 100)} mm2, made {round(volume)} mm2, {sys.argv[2]} warnings")
PY
done >seen
expect_in seen <<'END'
plain: seen 400 mm2, made 400 mm2, 0 warnings
display none: seen 200 mm2, made 400 mm2, 0 warnings
visibility hidden: seen 200 mm2, made 400 mm2, 0 warnings
symbol: seen 200 mm2, made 400 mm2, 0 warnings
pattern: seen 200 mm2, made 400 mm2, 0 warnings
clipped: seen 300 mm2, made 400 mm2, 0 warnings
use: seen 400 mm2, made 200 mm2, 0 warnings
lengths in px: seen 400 mm2, made 200 mm2, 0 warnings
END
