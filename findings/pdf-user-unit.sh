#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# UserUnit, by which PDF 1.6 allows sheets longer than 5.08 m: poppler 22.12 (pdfinfo, pdftoppm, pdftocairo) does not heed it and takes a
# page of 200 units of 2/72 in for 200 pt; MuPDF 1.21.1 draws 400. A plot printed by poppler is at half scale.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages mupdf-tools=1.21.1+ds2-1+deb12u1 poppler-utils=22.12.0-2+deb12u3
cat >page.pdf <<'PDF'
%PDF-1.7
1 0 obj
<</Type/Catalog/Pages 2 0 R>>
endobj
2 0 obj
<</Type/Pages/Kids[3 0 R]/Count 1>>
endobj
3 0 obj
<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 100]/UserUnit 2/Resources<<>>>>
endobj
xref
0 4
0000000000 65535 f 
0000000009 00000 n 
0000000054 00000 n 
0000000105 00000 n 
trailer
<</Size 4/Root 1 0 R>>
startxref
195
%%EOF
PDF
pdftoppm -r 72 page.pdf poppler 2>/dev/null
mutool draw -q -F pam -r 72 -o mupdf.pam page.pdf 2>/dev/null
{
  echo "pdfinfo: $(pdfinfo page.pdf 2>/dev/null | sed -n 's/^Page size: *//p')"
  echo "pdftoppm: $(sed -n 2p poppler-1.ppm | tr -d '\0')"
  echo "mutool: $(head -c 60 mupdf.pam | awk '/^WIDTH/ { w = $2 } /^HEIGHT/ { print w, $2; exit }')"
} 2>/dev/null >seen
expect_in seen <<'END'
pdfinfo: 200 x 100 pts
pdftoppm: 200 100
mutool: 400 200
END
