#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Pages with layers of which one is switched off, joined into a new file: qpdf 11.3.0 (--empty --pages), mutool 1.21.1 (merge) and
# pdf-lib 1.17.1 (copyPages) leave the catalogue's OCProperties behind, and the hidden layer is drawn. pdfunite 22.12 keeps it.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages pdf-lib@1.17.1
debian_packages qpdf=11.3.0-1+deb12u1 mupdf-tools=1.21.1+ds2-1+deb12u1 poppler-utils=22.12.0-2+deb12u3
python3 - <<'PY'
content = b"/OC /A BDC 0 0 50 50 re f EMC /OC /B BDC 50 0 50 50 re f EMC"
objects = [
    b"<</Type/Catalog/Pages 2 0 R/OCProperties<</OCGs[5 0 R 6 0 R]/D<</ON[5 0 R]/OFF[6 0 R]>>>>>>",
    b"<</Type/Pages/Kids[3 0 R]/Count 1>>",
    b"<</Type/Page/Parent 2 0 R/MediaBox[0 0 100 50]/Contents 4 0 R/Resources<</Properties<</A 5 0 R/B 6 0 R>>>>>>",
    b"<</Length %d>>stream\n%s\nendstream" % (len(content), content), b"<</Type/OCG/Name(on)>>", b"<</Type/OCG/Name(off)>>"]
file, places = b"%PDF-1.7\n", []
for number, text in enumerate(objects, 1):
    places.append(len(file))
    file += b"%d 0 obj\n%s\nendobj\n" % (number, text)
table = b"".join(b"%010d 00000 n \n" % place for place in places)
file += b"xref\n0 7\n0000000000 65535 f \n%strailer<</Size 7/Root 1 0 R>>\nstartxref\n%d\n%%%%EOF\n" % (table, len(file))
open("layers.pdf", "wb").write(file)
PY
cat >join.cjs <<'JS'
const { PDFDocument } = require('pdf-lib');
const fs = require('fs');
(async () => {
  const joined = await PDFDocument.create();
  const [page] = await joined.copyPages(await PDFDocument.load(fs.readFileSync('layers.pdf')), [0]);
  joined.addPage(page);
  fs.writeFileSync('pdf-lib.pdf', await joined.save());
})();
JS
qpdf --empty --pages layers.pdf 1 -- qpdf.pdf
mutool merge -o mutool.pdf layers.pdf 2>/dev/null
pdfunite layers.pdf layers.pdf pdfunite.pdf
node join.cjs
for file in layers qpdf mutool pdf-lib pdfunite; do
  pdftoppm -r 72 -f 1 -l 1 -gray "$file.pdf" "$file"
  python3 - "$file" <<'PY'
import glob, sys
data = open(glob.glob(sys.argv[1] + "-*.pgm")[0], "rb").read()
row = data[-100 * 25 : -100 * 24]
print(f"{sys.argv[1]}: layer on {'drawn' if row[25] < 128 else 'absent'}, layer off {'drawn' if row[75] < 128 else 'absent'}")
PY
done >seen
expect_in seen <<'END'
layers: layer on drawn, layer off absent
qpdf: layer on drawn, layer off drawn
mutool: layer on drawn, layer off drawn
pdf-lib: layer on drawn, layer off drawn
pdfunite: layer on drawn, layer off absent
END
