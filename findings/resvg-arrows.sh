#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# resvg (npm's @resvg/resvg-js 2.6.2) does not know orient="auto-start-reverse" of SVG 2 and turns the first arrowhead of a dimension line the
# wrong way, outside of the line, without a word; librsvg 2.54 draws it inside. Believed: as librsvg does.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @resvg/resvg-js@2.6.2
debian_packages librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
cat >dimension.svg <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="20mm" viewBox="0 0 100 20">
<marker id="arrow" viewBox="0 0 6 4" refX="6" refY="2" markerWidth="6" markerHeight="4" markerUnits="userSpaceOnUse" orient="auto-start-reverse"><path d="M0 0 6 2 0 4z"/></marker>
<path d="M20 10H80" stroke="#000" stroke-width="0.25" marker-start="url(#arrow)" marker-end="url(#arrow)"/>
</svg>
SVG
cat >resvg.cjs <<'JS'
const { Resvg } = require('@resvg/resvg-js');
const image = new Resvg(require('fs').readFileSync('dimension.svg', 'utf8'), { fitTo: { mode: 'width', value: 1000 }, background: 'white' }).render();
const row = (image.height / 2) | 0;
const black = [...Array(image.width).keys()].filter((x) => image.pixels[(row * image.width + x) * 4] < 128);
console.log(`resvg: black from x = ${Math.round(black[0] / 10)} to ${Math.round(black[black.length - 1] / 10)} mm`);
JS
{
  node resvg.cjs
  rsvg-convert -f pdf -b white -o librsvg.pdf dimension.svg
  pdftoppm -r 254 -gray -singlefile librsvg.pdf librsvg
  python3 - <<'PY'
data = open("librsvg.pgm", "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
row = data[len(data) - width * height + height // 2 * width :][:width]
black = [x for x in range(width) if row[x] < 128]
print(f"librsvg: black from x = {round(black[0] / 10)} to {round(black[-1] / 10)} mm")
PY
} >seen
expect_in seen <<'END'
resvg: black from x = 14 to 80 mm
librsvg: black from x = 20 to 80 mm
END
