#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Qt 5.15.8 (QSvgRenderer, below many viewers) and svg2pdf.js 2.8.1 take lengths in millimetres inside of an SVG for user units: a line
# from 5mm to 20mm is drawn from 5 to 20, and a width of 2mm as 2. Qt draws no dots of round caps, either. librsvg 2.54.7 has 96 user
# units an inch. Believed: as librsvg (SVG 1.1, 7.10), or a warning.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg2pdf.js@2.8.1 jspdf@4.2.1 jsdom@29.1.1
debian_packages python3-pyqt5=5.15.9+dfsg-1 python3-pyqt5.qtsvg=5.15.9+dfsg-1 librsvg2-bin=2.54.7+dfsg-1~deb12u2 poppler-utils=22.12.0-2+deb12u3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages QT_QPA_PLATFORM=offscreen QT_PLUGIN_PATH=$work/root/usr/lib/x86_64-linux-gnu/qt5/plugins
sheet() {  # NAME ELEMENT: on a sheet of 100 x 100
  echo "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100' viewBox='0 0 100 100'><g stroke='black'>$2</g></svg>" >"$1.svg"
}
sheet user-units '<line x1="5" y1="50" x2="20" y2="50" stroke-width="2"/>'
sheet places-in-mm '<line x1="5mm" y1="50" x2="20mm" y2="50" stroke-width="2"/>'
sheet width-in-mm '<line x1="5" y1="50" x2="20" y2="50" stroke-width="2mm"/>'
sheet circle-in-mm '<circle cx="10mm" cy="10mm" r="5mm"/>'
sheet dots '<line x1="5" y1="50" x2="18" y2="50" stroke-width="2" stroke-linecap="round" stroke-dasharray="0 5"/>'
cat >pdf.mjs <<'JS'
import { readFileSync, writeFileSync } from 'node:fs';
import { JSDOM } from 'jsdom';
import { jsPDF } from 'jspdf';

const { window } = new JSDOM('', { pretendToBeVisual: true });
for (const name of ['document', 'Element', 'Node', 'getComputedStyle', 'CSSStyleSheet', 'CSSStyleRule']) globalThis[name] = window[name];
const { svg2pdf } = await import('./node_modules/svg2pdf.js/dist/svg2pdf.es.min.js');
for (const name of process.argv.slice(2)) {
  document.body.innerHTML = readFileSync(name + '.svg', 'utf8');
  const pdf = new jsPDF({ unit: 'pt', format: [100, 100] });
  await svg2pdf(document.body.firstElementChild, pdf, { x: 0, y: 0, width: 100, height: 100 });
  writeFileSync(name + '.pdf', Buffer.from(pdf.output('arraybuffer')));
}
JS
cat >ink.py <<'PY'
import sys
from PyQt5.QtGui import QColor, QImage, QPainter
from PyQt5.QtSvg import QSvgRenderer

def box(image):  # of what is dark
    dark = [(x / 4, y / 4) for y in range(400) for x in range(400) if QColor(image.pixel(x, y)).lightness() < 128]
    return " ".join(f"{min(axis):.0f}..{max(axis):.0f}" for axis in zip(*dark)) or "nothing"

for name in sys.argv[1:]:
    image = QImage(400, 400, QImage.Format_RGB32)
    image.fill(QColor("white"))
    painter = QPainter(image)
    QSvgRenderer(name + ".svg").render(painter)
    painter.end()
    print(f"{name}: librsvg {box(QImage(name + '.png'))}, Qt {box(image)}, svg2pdf.js {box(QImage(name + '.2.png'))}")
PY
names=(user-units places-in-mm width-in-mm circle-in-mm dots)
node pdf.mjs "${names[@]}"
for name in "${names[@]}"; do
  rsvg-convert -w 400 -h 400 -b white $name.svg -o $name.png
  pdftoppm -r 288 -png -singlefile $name.pdf $name.2
done
/usr/bin/python3 ink.py "${names[@]}" 2>messages >seen
expect_in seen <<'END'
user-units: librsvg 5..20 49..51, Qt 5..20 49..51, svg2pdf.js 5..20 49..51
places-in-mm: librsvg 19..75 49..51, Qt 5..20 49..51, svg2pdf.js 5..20 49..51
width-in-mm: librsvg 5..20 46..54, Qt 5..20 49..51, svg2pdf.js 5..20 49..51
circle-in-mm: librsvg 18..57 18..57, Qt 4..15 4..15, svg2pdf.js 4..15 4..15
dots: librsvg 4..16 49..51, Qt nothing, svg2pdf.js 4..16 49..51
END
