#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# PyMuPDF 1.21.1 (Page.get_drawings) has one closePath for a whole path: of two closed triangles in one path, as drawings often write them, it has
# four lines of six, and of a triangle and a line nothing tells which of them is closed. closePath of a filled path is False. Squares upright
# on the page are rectangles, with all sides. Believed: each line that is drawn.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-fitz=1.21.1+ds1-1+b4
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >lines.py <<'PY'
import fitz

def drawings_of(content):
    objects = ["<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>", "<</Type/Page/Parent 2 0 R/MediaBox[0 0 200 200]/Contents 4 0 R/Resources<<>>>>",
               f"<</Length {len(content)}>>stream\n{content}\nendstream"]
    text, places = "%PDF-1.4\n", []
    for number, it in enumerate(objects, 1):
        places.append(len(text))
        text += f"{number} 0 obj\n{it}\nendobj\n"
    table = "".join(f"{place:010} 00000 n \n" for place in places)
    text += f"xref\n0 5\n0000000000 65535 f \n{table}trailer<</Size 5/Root 1 0 R>>\nstartxref\n{len(text)}\n%%EOF"
    document = fitz.open(stream=text.encode(), filetype="pdf")
    return document[0].get_drawings()

triangle, other = "10 10 m 50 12 l 52 30 l h", "60 10 m 100 12 l 102 30 l h"
for name, lines, content in [
    ("triangle", 3, triangle + " S"), ("two triangles, each painted", 6, f"{triangle} S {other} S"), ("two triangles in one path", 6, f"{triangle} {other} S"),
    ("triangle and line in one path", 4, triangle + " 60 10 m 100 12 l S"), ("two lines at an angle", 2, triangle[:-2] + " S"), ("filled triangle", 3, triangle + " f"),
]:
    drawings = drawings_of(content)
    count = sum(len(it["items"]) for it in drawings)
    print(f"{name}: {lines} lines drawn, {count} items, closePath {' '.join(str(it['closePath']) for it in drawings)}")
PY
/usr/bin/python3 lines.py >seen
expect_in seen <<'END'
triangle: 3 lines drawn, 2 items, closePath True
two triangles, each painted: 6 lines drawn, 4 items, closePath True True
two triangles in one path: 6 lines drawn, 4 items, closePath True
triangle and line in one path: 4 lines drawn, 3 items, closePath True
two lines at an angle: 2 lines drawn, 2 items, closePath False
filled triangle: 3 lines drawn, 2 items, closePath False
END
