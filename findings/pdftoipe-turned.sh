#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# pdftoipe 7.2.24.1 (PDF into Ipe, to edit drawings) turns what is on a turned page (/Rotate), as many programs write sheets in landscape, but not its
# paper: of a line along a landscape page of 300 x 200 pt, turned by 90 degrees, which lies on 200 x 300 then, Ipe's PDF cuts a third off.
# It draws what the PDF clips, such as the border of a detail, whole. It says nothing. Pages that are not turned, dashes and cropped pages
# are right. Believed: the page that other readers show.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages pdftoipe=1:7.2.24.1-3.1
page() {  # WHAT ATTRIBUTES CONTENT
  python3 - "$2" "$3" <<'PY'
import sys
objects = ["<< /Type /Catalog /Pages 2 0 R >>", "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
           f"<< /Type /Page /Parent 2 0 R {sys.argv[1]} /Contents 4 0 R /Resources << >> >>", f"<< /Length {len(sys.argv[2])} >>\nstream\n{sys.argv[2]}\nendstream"]
text, places = "%PDF-1.6\n", []
for number, entry in enumerate(objects, 1):
    places.append(len(text))
    text += f"{number} 0 obj\n{entry}\nendobj\n"
table = "".join(f"{place:010d} 00000 n \n" for place in places)
text += f"xref\n0 5\n0000000000 65535 f \n{table}trailer\n<< /Root 1 0 R /Size 5 >>\nstartxref\n{len(text)}\n%%EOF\n"
open("page.pdf", "w").write(text)
PY
  pdftoipe -q page.pdf page.ipe >messages 2>&1
  echo "$1: $(sed -n 's/.*paper="\([^"]*\)".*/paper \1/p' page.ipe), line $(sed -n '/<path/,/<\/path/p' page.ipe | grep -E ' [ml]$' | tr '\n' ' ')"
}
{
  page 'not turned' '/MediaBox [0 0 300 200]' '1 w 10 10 m 290 10 l S'
  page 'turned by 90 degrees' '/MediaBox [0 0 300 200] /Rotate 90' '1 w 10 10 m 290 10 l S'
  page 'clipped to 20 to 70' '/MediaBox [0 0 300 200]' '20 0 50 200 re W n 1 w 10 10 m 290 10 l S'
  page 'cropped to 100 to 200' '/MediaBox [0 0 300 200] /CropBox [100 0 200 200]' '1 w 110 10 m 190 10 l S'
} >seen
expect_in seen <<'END'
not turned: paper 300 200, line 10 10 m 290 10 l 
turned by 90 degrees: paper 300 200, line 10 290 m 10 10 l 
clipped to 20 to 70: paper 300 200, line 10 10 m 290 10 l 
cropped to 100 to 200: paper 300 200, line 10 10 m 90 10 l 
END
