#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Texts of a PDF's layers that are off, such as those of another language: pdfminer.six 20221105, pypdf 3.4.1 and pdf.js 6.5.438 (the viewer of
# Firefox, whose search finds them) give them as text of the page, though pdf.js draws none of them; poppler 22.12 gives what is seen. A
# program that reads sizes or a parts list from the sheet has them twice. Believed: text is what is seen, or each program has an option.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages pdfjs-dist@6.5.438
debian_packages python3-pdfminer=20221105+dfsg-1.1~deb12u1 python3-pypdf=3.4.1-1+deb12u1 poppler-utils=22.12.0-2+deb12u3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >sheet.py <<'PY'
content = ("BT /F 10 Tf 10 80 Td (always) Tj ET /OC /A BDC BT /F 10 Tf 10 50 Td (seen) Tj ET EMC "
           "/OC /B BDC BT /F 10 Tf 10 20 Td (unseen) Tj ET EMC")
things = ["<< /Type /Catalog /Pages 2 0 R /OCProperties << /OCGs [6 0 R 7 0 R] /D << /Order [6 0 R 7 0 R] /OFF [7 0 R] >> >> >>",
          "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
          "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 200 100] /Contents 4 0 R /Resources << /Font << /F 5 0 R >> /Properties << /A 6 0 R /B 7 0 R >> >> >>",
          f"<< /Length {len(content)} >>\nstream\n{content}\nendstream",
          "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>", "<< /Type /OCG /Name (English) >>", "<< /Type /OCG /Name (Deutsch) >>"]
text, places = "%PDF-1.5\n", []
for i, thing in enumerate(things):
    places.append(len(text))
    text += f"{i + 1} 0 obj\n{thing}\nendobj\n"
table = "".join(f"{place:010d} 00000 n \n" for place in places)
with open("sheet.pdf", "w") as file:
    file.write(f"{text}xref\n0 8\n0000000000 65535 f \n{table}trailer\n<< /Size 8 /Root 1 0 R >>\nstartxref\n{len(text)}\n%%EOF\n")
PY
cat >texts.mjs <<'JS'
import { readFileSync } from 'fs';
Promise.withResolvers ??= function () {  // which Node.js 20 lacks
  const parts = {};
  parts.promise = new Promise((resolve, reject) => Object.assign(parts, { resolve, reject }));
  return parts;
};
const { getDocument } = await import('pdfjs-dist/legacy/build/pdf.mjs');
const page = await (await getDocument({ data: new Uint8Array(readFileSync('sheet.pdf')), verbosity: 0 }).promise).getPage(1);
console.log('pdf.js:', (await page.getTextContent()).items.map((item) => item.str).filter(Boolean).join(' '));
process.exit();
JS
python3 sheet.py
{
  echo "pdftotext:" $(pdftotext sheet.pdf - | tr -d '\f')
  echo "pdfminer:" $(/usr/bin/python3 -c 'import pdfminer.high_level as m; print(m.extract_text("sheet.pdf").replace("\f", ""))')
  echo "pypdf:" $(/usr/bin/python3 -c 'import pypdf; print(pypdf.PdfReader("sheet.pdf").pages[0].extract_text())')
  node texts.mjs
} >seen
expect_in seen <<'END'
pdftotext: always seen
pdfminer: always seen unseen
pypdf: always seen unseen
pdf.js: always seen unseen
END
