#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Qt 5.15.8 (below LibreCAD, FreeCAD and QElectroTech) writes the dashes of pens thinner than half a unit into SVG as though the pen were one unit thick
# (QSvgGenerator): hidden lines of 0.25 mm on a sheet in millimetres get dashes of 8 mm instead of 2, and in metres one of 8 m, a solid line. PDF
# (QPdfWriter) has it below 0.001, such as all pens in metres. Nothing is said; pictures of the same drawing are right. Believed: dashes in
# widths of the pen (QPen::setDashPattern).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-pyqt5=5.15.9+dfsg-1 python3-pyqt5.qtsvg=5.15.9+dfsg-1
library=$work/root/usr/lib/x86_64-linux-gnu
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages QT_QPA_PLATFORM=offscreen QT_PLUGIN_PATH=$library/qt5/plugins HOME=$work
cat >dashes.py <<'PY'
import re
import zlib
from PyQt5.QtCore import QLineF, QRect, QSize, QSizeF, Qt
from PyQt5.QtGui import QGuiApplication, QImage, QPainter, QPdfWriter, QPen
from PyQt5.QtSvg import QSvgGenerator


def draw(device, scale, unit, width):
    """A line of 180 mm, dashed by 8 and 4 widths of a pen of the width in millimetres, in a drawing whose unit is so many millimetres."""
    painter = QPainter(device)
    painter.scale(scale * unit, scale * unit)
    pen = QPen(Qt.black, width / unit)
    pen.setCapStyle(Qt.FlatCap)
    pen.setDashPattern([8, 4])
    painter.setPen(pen)
    painter.drawLine(QLineF(0, 20 / unit, 180 / unit, 20 / unit))
    painter.end()


application = QGuiApplication([])
for name, unit in (("millimetres", 1), ("inches", 25.4), ("metres", 1000)):
    for width in (0.25, 0.35, 0.7, 1.4):
        sheet = QSvgGenerator()
        sheet.setFileName("sheet.svg")
        sheet.setSize(QSize(200, 40))
        sheet.setViewBox(QRect(0, 0, 200, 40))
        draw(sheet, 1, unit, width)
        svg = [float(word) * unit for word in re.search(r'stroke-dasharray="([^"]*)"', open("sheet.svg").read())[1].split(",")]
        paper = QPdfWriter("sheet.pdf")
        paper.setPageSizeMM(QSizeF(200, 40))
        paper.setResolution(254)
        draw(paper, 10, unit, width)
        streams = re.findall(rb"stream\n(.*?)endstream", open("sheet.pdf", "rb").read(), re.S)
        text = b"".join(zlib.decompress(stream) if stream[:1] == b"x" else stream for stream in streams)
        pdf = [float(word) * unit for word in re.findall(rb"\[([\d.]+ [\d.]+) ?\]", text)[-1].split()]
        image = QImage(2000, 400, QImage.Format_RGB32)
        image.fill(Qt.white)
        draw(image, 10, unit, width)
        dark = [image.pixelColor(x, 200).value() < 200 for x in range(2000)]
        count = sum(here and not there for here, there in zip(dark, dark[1:]))
        told = ["{:.4g} and {:.4g} mm".format(*dashes) for dashes in ((8 * width, 4 * width), svg, pdf)]
        print(f"pen of {width} mm in {name}: SVG {told[1]}, PDF {told[2]}, picture of {count} dashes" +
              ("" if told[1] == told[2] == told[0] else f", right would be {told[0]}"))
PY
/usr/bin/python3 dashes.py >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
pen of 0.25 mm in millimetres: SVG 8 and 4 mm, PDF 2 and 1 mm, picture of 60 dashes, right would be 2 and 1 mm
pen of 0.35 mm in millimetres: SVG 8 and 4 mm, PDF 2.8 and 1.4 mm, picture of 43 dashes, right would be 2.8 and 1.4 mm
pen of 0.7 mm in millimetres: SVG 5.6 and 2.8 mm, PDF 5.6 and 2.8 mm, picture of 22 dashes
pen of 1.4 mm in millimetres: SVG 11.2 and 5.6 mm, PDF 11.2 and 5.6 mm, picture of 11 dashes
pen of 0.25 mm in inches: SVG 203.2 and 101.6 mm, PDF 2 and 1 mm, picture of 60 dashes, right would be 2 and 1 mm
pen of 0.35 mm in inches: SVG 203.2 and 101.6 mm, PDF 2.8 and 1.4 mm, picture of 43 dashes, right would be 2.8 and 1.4 mm
pen of 0.7 mm in inches: SVG 203.2 and 101.6 mm, PDF 5.6 and 2.8 mm, picture of 22 dashes, right would be 5.6 and 2.8 mm
pen of 1.4 mm in inches: SVG 203.2 and 101.6 mm, PDF 11.2 and 5.6 mm, picture of 11 dashes, right would be 11.2 and 5.6 mm
pen of 0.25 mm in metres: SVG 8000 and 4000 mm, PDF 8000 and 4000 mm, picture of 60 dashes, right would be 2 and 1 mm
pen of 0.35 mm in metres: SVG 8000 and 4000 mm, PDF 8000 and 4000 mm, picture of 43 dashes, right would be 2.8 and 1.4 mm
pen of 0.7 mm in metres: SVG 8000 and 4000 mm, PDF 8000 and 4000 mm, picture of 22 dashes, right would be 5.6 and 2.8 mm
pen of 1.4 mm in metres: SVG 8000 and 4000 mm, PDF 11.2 and 5.6 mm, picture of 11 dashes, right would be 11.2 and 5.6 mm
END
