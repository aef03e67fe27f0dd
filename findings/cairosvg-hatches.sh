#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# CairoSVG 2.5.2 rounds the tile of a pattern up to whole points of 4/3 of a unit, and draws hatches that much wider: lines 3 mm apart on a sheet in
# millimetres become 4 mm apart, 2.5 become 2.67, 10 become 10.67. It ignores clip-rule, so that what is cut out of a clip path is drawn over. Nothing is said. Tiles
# of whole multiples of 4, and hatches drawn as lines, are right. Believed: as librsvg 2.54 draws them (SVG 1.1, 13.3 and 14.3.5).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-cairosvg=2.5.2-1.1+deb12u1 librsvg2-bin=2.54.7+dfsg-1~deb12u2
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >hatches.py <<'PY'
import io
import subprocess
import cairocffi
import cairosvg


def edges(png):
    """Where ink begins on the middle row of a picture of 2000 pixels, in millimetres of a sheet of 200."""
    image = cairocffi.ImageSurface.create_from_png(io.BytesIO(png))
    data, stride, row = bytes(image.get_data()), image.get_stride(), image.get_height() // 2
    dark = [data[row * stride + 4 * x + 1] < 128 for x in range(image.get_width())]
    return [x / 10 for x in range(1, len(dark)) if dark[x] and not dark[x - 1]]


def draw(shapes):
    text = f"""<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">
      <rect width="200" height="100" fill="white"/>{shapes}</svg>""".encode()
    with open("sheet.svg", "wb") as file:
        file.write(text)
    return {"CairoSVG": edges(cairosvg.svg2png(bytestring=text, output_width=2000, output_height=1000)),
            "librsvg": edges(subprocess.run(["rsvg-convert", "-w", "2000", "-h", "1000", "sheet.svg"], capture_output=True, check=True).stdout)}


for step in (2.5, 3, 4, 10, 20):
    seen = draw(f"""<pattern id="hatch" width="{step}" height="{step}" patternUnits="userSpaceOnUse"><rect width="{step / 2}" height="{step}"/></pattern>
      <rect x="5" y="10" width="190" height="80" fill="url(#hatch)"/>""")
    told = {name: (places[-1] - places[2]) / (len(places) - 3) for name, places in seen.items()}
    print(f"lines {step} mm apart: " + ", ".join(f"{name} {value:.2f}" for name, value in told.items()))
seen = draw("""<clipPath id="part"><path clip-rule="evenodd" d="M10 10H190V90H10ZM60 20H140V80H60Z"/></clipPath>
  <g clip-path="url(#part)"><rect x="30" y="40" width="20" height="20"/><rect x="90" y="40" width="20" height="20"/></g>""")
print("of two squares, one within a hole of the clip path: " + ", ".join(f"{name} {len(places)}" for name, places in seen.items()))
PY
/usr/bin/python3 hatches.py >seen
expect_in seen <<'END'
lines 2.5 mm apart: CairoSVG 2.67, librsvg 2.50
lines 3 mm apart: CairoSVG 4.00, librsvg 3.00
lines 4 mm apart: CairoSVG 4.00, librsvg 4.00
lines 10 mm apart: CairoSVG 10.67, librsvg 10.00
lines 20 mm apart: CairoSVG 20.00, librsvg 20.00
of two squares, one within a hole of the clip path: CairoSVG 2, librsvg 1
END
