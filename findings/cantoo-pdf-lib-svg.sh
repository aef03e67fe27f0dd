#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @cantoo/pdf-lib 2.11.1 (npm; drawSvg) draws dashed lines of SVG solid, and what visibility or display hides; it leaves out polylines, copies by
# <use> and clips, makes square corners of round ones, and takes millimetres for user units, and lines of style="stroke-width:4" for 1 wide.
# Nothing is said. Transforms, arcs, ellipses, nested view boxes and holes are right. Believed: as librsvg 2.54 does.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
npm_packages @cantoo/pdf-lib@2.11.1
cat >draw.js <<'JS'
const fs = require("fs");
const { PDFDocument } = require("@cantoo/pdf-lib");
(async () => {
  for (const name of process.argv.slice(2)) {
    const file = await PDFDocument.create();
    file.addPage([100, 100]).drawSvg(fs.readFileSync(`${name}.svg`, "utf8"), { x: 0, y: 100, width: 100, height: 100 });
    fs.writeFileSync(`${name}-cantoo.pdf`, await file.save());
  }
})();
JS
cat >ink.py <<'PY'
import sys
data = open(sys.argv[1], "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
black = sum(value < 128 for value in data[len(data) - width * height:])
print(round(black * 10000 / (width * height), -1 if black > 30000 else None))
PY
shapes() {
  cat <<'SHAPES'
turned|<rect x="20" width="30" height="40" fill="#000" transform="translate(10 0) rotate(30)"/>
arc|<path d="M10 50A30 15 30 0 1 60 50" fill="none" stroke="#000"/>
hole|<path fill-rule="evenodd" fill="#000" d="M10 10H90V90H10ZM30 30H70V70H30Z"/>
dashed|<path d="M0 50H100" stroke="#000" stroke-dasharray="4 4"/>
hidden|<path d="M0 50H100" stroke="#000" visibility="hidden"/>
not-displayed|<path d="M0 50H100" stroke="#000" display="none"/>
polyline|<polyline points="0,50 50,50 50,90" fill="none" stroke="#000"/>
copies|<defs><path id="a" d="M0 0H50" stroke="#000"/></defs><use href="#a" y="20"/><use href="#a" y="40"/>
clipped|<clipPath id="c"><rect x="20" y="20" width="30" height="30"/></clipPath><g clip-path="url(#c)"><path d="M0 30H100" stroke="#000"/></g>
round|<rect x="10" y="10" width="80" height="40" rx="20" fill="#000"/>
millimetres|<rect width="20mm" height="10mm" fill="#000"/>
style|<path d="M0 50H100" style="stroke:#000;stroke-width:4"/>
SHAPES
}
shapes | while IFS='|' read -r name shape; do
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100\" height=\"100\" viewBox=\"0 0 100 100\">$shape</svg>" >"$name.svg"
  rsvg-convert -f pdf -b white -o "$name-librsvg.pdf" "$name.svg"
done
node draw.js $(shapes | cut -d '|' -f 1)
shapes | while IFS='|' read -r name shape; do
  for program in cantoo librsvg; do pdftoppm -scale-to 400 -gray -singlefile "$name-$program.pdf" "$name-$program"; done
  echo "$name: $(python3 ink.py "$name-cantoo.pgm") of 10000 black, librsvg $(python3 ink.py "$name-librsvg.pgm")"
done >seen
expect_in seen <<'END'
turned: 1201 of 10000 black, librsvg 1201
arc: 81 of 10000 black, librsvg 81
hole: 4800.0 of 10000 black, librsvg 4800.0
dashed: 100 of 10000 black, librsvg 52
hidden: 100 of 10000 black, librsvg 0
not-displayed: 100 of 10000 black, librsvg 0
polyline: 0 of 10000 black, librsvg 90
copies: 0 of 10000 black, librsvg 100
clipped: 100 of 10000 black, librsvg 30
round: 3200.0 of 10000 black, librsvg 2860.0
millimetres: 200 of 10000 black, librsvg 2850.0
style: 100 of 10000 black, librsvg 400
END
