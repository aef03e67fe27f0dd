#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pdfmake 0.2.20 takes the number of an SVG's width for points, whatever its unit: 100 mm, 10 cm and 4 in come out 35.3, 3.5 and 1.4 mm
# wide. SVG-to-PDFKit 0.1.8, on which it stands, has 100, 100 and 101.6 mm. Believed: the same, since a length of SVG has its unit
# (SVG 1.1, 7.10). A width given in the document (283.465 pt) is right.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages pdfmake@0.2.20 svg-to-pdfkit@0.1.8 pdfkit@0.15.2
cat >draw.cjs <<'JS'
const fs = require('fs'), PdfPrinter = require('pdfmake/src/printer'), PdfKit = require('pdfkit'), svgToPdf = require('svg-to-pdfkit');
const drawing = width => `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${width}" viewBox="0 0 50 50"><path d="M0 0H50V50H0z" stroke="#000" fill="none"/></svg>`;
const save = (pdf, name) => { pdf.pipe(fs.createWriteStream(name)); return pdf; };
for (const width of ['100mm', '10cm', '4in', '']) {
  const svg = drawing(width || '100mm'), printed = { pageSize: 'A3', pageMargins: 0, compress: false, content: [width ? { svg } : { svg, width: 283.465 }] };
  save(new PdfPrinter({}).createPdfKitDocument(printed), `pdfmake ${width || 'with a width'}.pdf`).end();
  if (!width) continue;
  const plain = save(new PdfKit({ size: 'A3', margin: 0, compress: false }), `svg-to-pdfkit ${width}.pdf`);
  svgToPdf(plain, svg, 0, 0);
  plain.end();
}
JS
node draw.cjs
for name in 'pdfmake 100mm' 'svg-to-pdfkit 100mm' 'pdfmake 10cm' 'svg-to-pdfkit 10cm' 'pdfmake 4in' 'svg-to-pdfkit 4in' 'pdfmake with a width'; do
  python3 - "$name" <<'PY'
import re, sys
page = re.search(rb"stream\n(.*?)endstream", open(sys.argv[1] + ".pdf", "rb").read(), re.S)[1].decode()
scale, places, stack = 1, [], []
for line in page.splitlines():
    *values, operator = line.split() or [""]
    if operator == "q":
        stack.append(scale)
    elif operator == "Q":
        scale = stack.pop()
    elif operator == "cm":
        scale *= float(values[0])
    elif operator in ("m", "l"):
        places.append(scale * float(values[0]))
print(f"{sys.argv[1]}: {(max(places) - min(places)) * 25.4 / 72:.1f} mm wide")
PY
done >seen
expect_in seen <<'END'
pdfmake 100mm: 35.3 mm wide
svg-to-pdfkit 100mm: 100.0 mm wide
pdfmake 10cm: 3.5 mm wide
svg-to-pdfkit 10cm: 100.0 mm wide
pdfmake 4in: 1.4 mm wide
svg-to-pdfkit 4in: 101.6 mm wide
pdfmake with a width: 100.0 mm wide
END
