#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A dotted line in PDF as dashes of no length with projecting square caps, [0 8] 0 d 2 J: ISO 32000 8.5.3.2 asks for the squares, since the
# line gives them their direction. poppler 22.12 (pdftoppm) draws nothing at all; with round caps it draws the dots. Believed: 10 squares
# of 2 x 2, 40 in area, as MuPDF 1.21.1 and Ghostscript 10.0 draw them.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages mupdf-tools=1.21.1+ds2-1+deb12u1 poppler-utils=22.12.0-2+deb12u3 ghostscript=10.0.0~dfsg-11+deb12u9
export GS_LIB=$work/root/usr/share/ghostscript/10.00.0/Resource/Init:$work/root/usr/share/ghostscript/10.00.0/lib
for caps in 'round 1' 'square 2'; do
  python3 - "${caps#* }" <<'PY'
import sys
content = f"2 w {sys.argv[1]} J [0 8] 0 d 10 25 m 90 25 l S"
objects = ["<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
           "<</Type/Page/Parent 2 0 R/MediaBox[0 0 100 50]/Contents 4 0 R/Resources<<>>>>",
           f"<</Length {len(content)}>>stream\n{content}\nendstream"]
file, places = "%PDF-1.4\n", []
for number, text in enumerate(objects, 1):
    places.append(len(file))
    file += f"{number} 0 obj\n{text}\nendobj\n"
table = "".join(f"{place:010} 00000 n \n" for place in places)
file += f"xref\n0 5\n0000000000 65535 f \n{table}trailer\n<</Size 5/Root 1 0 R>>\nstartxref\n{len(file)}\n%%EOF\n"
open("dots.pdf", "w").write(file)
PY
  pdftoppm -r 720 -gray -singlefile dots.pdf poppler
  mutool draw -q -r 720 -c gray -o mupdf.pgm dots.pdf 2>/dev/null
  gs -q -dNOPAUSE -dBATCH -r720 -sDEVICE=pgmraw -o ghostscript.pgm dots.pdf
  for name in poppler mupdf ghostscript; do
    python3 - "${caps% *} caps, $name" $name.pgm <<'PY'
import sys
pixels = open(sys.argv[2], "rb").read()[-1000 * 500:]
print(f"{sys.argv[1]}: {round(sum(pixel < 128 for pixel in pixels) / 100)} black")
PY
  done
done >seen
expect_in seen <<'END'
round caps, poppler: 31 black
round caps, mupdf: 30 black
round caps, ghostscript: 38 black
square caps, poppler: 0 black
square caps, mupdf: 40 black
square caps, ghostscript: 40 black
END
