#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# plakativ 0.5.1, which divides large sheets into pages, lays out a sheet that is turned (/Rotate 90, as is usual for landscape ones)
# by its unturned size, and cuts the turned drawing off there: of a frame of 180 x 380 mm 190 x 180 are left. No message. Believed: as
# viewers show it, 180 x 380.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages plakativ=0.5.1-1 poppler-utils=22.12.0-2+deb12u3
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
for turn in 0 90 180; do
  python3 - $turn <<'PY'
import sys
mm = 72 / 25.4
content = f"{mm} 0 0 {mm} 0 0 cm 1 w 10 10 380 180 re S"
objects = ["<</Type/Catalog/Pages 2 0 R>>", "<</Type/Pages/Kids[3 0 R]/Count 1>>",
           f"<</Type/Page/Parent 2 0 R/MediaBox[0 0 {400 * mm:.4f} {200 * mm:.4f}]/Rotate {sys.argv[1]}/Contents 4 0 R/Resources<<>>>>",
           f"<</Length {len(content)}>>\nstream\n{content}\nendstream"]
text, offsets = "%PDF-1.4\n", []
for number, body in enumerate(objects, 1):
    offsets.append(len(text))
    text += f"{number} 0 obj\n{body}\nendobj\n"
table = "".join(f"{offset:010d} 00000 n \n" for offset in offsets)
open("sheet.pdf", "w").write(f"{text}xref\n0 5\n0000000000 65535 f \n{table}trailer\n<</Size 5/Root 1 0 R>>\nstartxref\n{len(text)}\n%%EOF\n")
PY
  for sheet in sheet poster; do
    [ $sheet = sheet ] || plakativ --factor 1 --pagesize 500x500mm --border 0mm -o poster.pdf sheet.pdf 2>messages || { cat messages >&2; exit 1; }
    pdftoppm -r 25.4 -gray -singlefile $sheet.pdf picture
    python3 - "turned by $turn, $sheet" <<'PY'
import sys
data = open("picture.pgm", "rb").read()
width, height = map(int, data.split(None, 3)[1:3])
black = [divmod(i, width) for i, pixel in enumerate(data[-width * height:]) if pixel < 200]
across, up = (max(place[i] for place in black) - min(place[i] for place in black) for i in (1, 0))
print(f"{sys.argv[1]}: ink on {round(across, -1)} x {round(up, -1)} mm")
PY
  done
done >seen
expect_in seen <<'END'
turned by 0, sheet: ink on 380 x 180 mm
turned by 0, poster: ink on 380 x 180 mm
turned by 90, sheet: ink on 180 x 380 mm
turned by 90, poster: ink on 190 x 180 mm
turned by 180, sheet: ink on 380 x 180 mm
turned by 180, poster: ink on 380 x 180 mm
END
