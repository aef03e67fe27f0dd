#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Where CSS places shapes of an SVG, as browsers draw them, converters differ: what style="transform: ..." moves is drawn where it was by resvg-js 2.6.2
# and Qt 5.15.8; transform-origin is ignored by these and librsvg 2.54, so that a shape which grows about its middle leaves the sheet; x and width in a
# style are ignored by resvg and Qt, whose shape is missing; and none of four, CairoSVG 2.5.2 neither, heeds pathLength, so that dashes that fill a fifth
# each become a grey line. Nothing is said. The attribute transform is right in all. Believed: as SVG 2 (7.2, 8.5, 9.6.1) and CSS Transforms 1 have it, after
# ten years.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @resvg/resvg-js@2.6.2
debian_packages librsvg2-bin=2.54.7+dfsg-1~deb12u2 python3-cairosvg=2.5.2-1.1+deb12u1 python3-pyqt5=5.15.9+dfsg-1 python3-pyqt5.qtsvg=5.15.9+dfsg-1
library=$work/root/usr/lib/x86_64-linux-gnu
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages QT_QPA_PLATFORM=offscreen QT_PLUGIN_PATH=$library/qt5/plugins HOME=$work
cat >resvg.js <<'JS'
const { Resvg } = require("@resvg/resvg-js");
const fs = require("fs");
fs.writeFileSync("resvg.png", new Resvg(fs.readFileSync("sheet.svg", "utf8")).render().asPng());
JS
cat >places.py <<'PY'
import subprocess
import cairosvg
from PyQt5.QtGui import QGuiApplication, QImage, QPainter
from PyQt5.QtSvg import QSvgRenderer

application = QGuiApplication([])


def ink(image):
    """From where to where ink lies on the middle row of a picture of 100 pixels, one each millimetre; in how many pieces if there are some."""
    dark = [image.pixelColor(x, 50).value() < 128 for x in range(image.width())]
    starts = [x for x in range(100) if dark[x] and not (x and dark[x - 1])]
    ends = [x + 1 for x in range(100) if dark[x] and not (x < 99 and dark[x + 1])]
    return "nothing" if not starts else f"{starts[0]} to {ends[-1]}" + (f" in {len(starts)} dashes" if len(starts) > 1 else "")


BOX = '<rect x="40" y="45" width="20" height="10" {}/>'
for what, shape, right in (
        ("transform as an attribute", BOX.format('transform="translate(30)"'), "70 to 90"),
        ("transform in a style", BOX.format('style="transform: translate(30px)"'), "70 to 90"),
        ("scale by 3 about the middle", BOX.format('transform="scale(3 1)" transform-origin="50 50"'), "20 to 80"),
        ("x and width in a style", '<rect y="45" height="10" style="x: 20px; width: 60px"/>', "20 to 80"),
        ("dashes of 1 on a path of 10", '<path d="M0 50H100" pathLength="10" stroke="black" stroke-width="10" stroke-dasharray="1"/>', "0 to 90 in 5 dashes")):
    text = f'<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" viewBox="0 0 100 100"><rect width="100" height="100" fill="white"/>{shape}</svg>'
    with open("sheet.svg", "w") as file:
        file.write(text)
    subprocess.run(["rsvg-convert", "-o", "librsvg.png", "sheet.svg"], check=True)
    subprocess.run(["node", "resvg.js"], check=True)
    cairosvg.svg2png(bytestring=text.encode(), write_to="cairosvg.png")
    picture = QImage(100, 100, QImage.Format_RGB32)
    painter = QPainter(picture)
    QSvgRenderer("sheet.svg").render(painter)
    painter.end()
    picture.save("qt.png")
    seen = {name: ink(QImage(name.lower() + ".png")) for name in ("librsvg", "CairoSVG", "resvg", "Qt")}
    print(f"{what}, {right}: " + "; ".join(f"{name} {told}" for name, told in seen.items()))
PY
/usr/bin/python3 places.py >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
transform as an attribute, 70 to 90: librsvg 70 to 90; CairoSVG 70 to 90; resvg 70 to 90; Qt 70 to 90
transform in a style, 70 to 90: librsvg 70 to 90; CairoSVG 70 to 90; resvg 40 to 60; Qt 40 to 60
scale by 3 about the middle, 20 to 80: librsvg nothing; CairoSVG 20 to 80; resvg nothing; Qt nothing
x and width in a style, 20 to 80: librsvg 20 to 80; CairoSVG 20 to 80; resvg nothing; Qt nothing
dashes of 1 on a path of 10, 0 to 90 in 5 dashes: librsvg 0 to 99 in 50 dashes; CairoSVG 0 to 99 in 50 dashes; resvg 0 to 99 in 50 dashes; Qt 0 to 99 in 50 dashes
END
