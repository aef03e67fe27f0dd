#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Qt 5.15.8 writes SVG (QSvgGenerator) without what it was told to clip by: of a detail clipped by a circle the whole part is drawn, across the sheet. Its
# hatches become grids of 8 x 8 squares of one unit each, a millimetre on a sheet in millimetres, and a line in metres has six digits. Nothing is
# said. Its PDF and pictures of the same drawing are clipped. Believed: as drawn: QSvgGenerator's page names no such limit.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-pyqt5=5.15.9+dfsg-1 python3-pyqt5.qtsvg=5.15.9+dfsg-1
library=$work/root/usr/lib/x86_64-linux-gnu
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages QT_QPA_PLATFORM=offscreen QT_PLUGIN_PATH=$library/qt5/plugins HOME=$work
cat >clips.py <<'PY'
import re
import zlib
from PyQt5.QtCore import QPointF, QRect, QRectF, QSize, QSizeF, Qt
from PyQt5.QtGui import QBrush, QColor, QGuiApplication, QImage, QPainter, QPainterPath, QPdfWriter, QPen
from PyQt5.QtSvg import QSvgGenerator, QSvgRenderer


def svg(draw):
    sheet = QSvgGenerator()
    sheet.setFileName("sheet.svg")
    sheet.setSize(QSize(200, 100))
    sheet.setViewBox(QRect(0, 0, 200, 100))
    painter = QPainter(sheet)
    draw(painter)
    painter.end()
    return open("sheet.svg").read()


def extent(image):
    dark = [(x, y) for y in range(image.height()) for x in range(image.width()) if image.pixelColor(x, y).value() < 128]
    return "{} to {} mm".format(round(min(x for x, _ in dark) / 5), round((max(x for x, _ in dark) + 1) / 5))


def picture(draw):
    image = QImage(1000, 500, QImage.Format_RGB32)
    image.fill(Qt.white)
    painter = QPainter(image)
    painter.scale(5, 5)
    draw(painter)
    painter.end()
    return image


def detail(clip):
    def draw(painter):
        if clip == "rectangle":
            painter.setClipRect(QRectF(80, 30, 40, 40))
        elif clip == "circle":
            circle = QPainterPath()
            circle.addEllipse(QPointF(100, 50), 20, 20)
            painter.setClipPath(circle)
        painter.fillRect(QRectF(10, 45, 180, 10), QColor("black"))
    return draw


application = QGuiApplication([])
for clip in ("nothing", "rectangle", "circle"):
    svg(detail(clip))
    print(f"bar from 10 to 190 mm clipped by {clip}: picture {extent(picture(detail(clip)))}, "
          f"SVG {extent(picture(lambda painter: QSvgRenderer('sheet.svg').render(painter, QRectF(0, 0, 200, 100))))}")
hatch = svg(lambda painter: (painter.setBrush(QBrush(Qt.black, Qt.BDiagPattern)), painter.drawRect(QRectF(20, 20, 100, 50))))
tile = re.search(r'<mask .*? width="(\d+)" height="(\d+)"', hatch).groups()
squares = re.findall(r'<rect x="(\d+)" y="(\d+)" width="1" height="1"', hatch)
print(f"hatch: tiles of {tile[0]} x {tile[1]} units with {len(squares)} squares of 1 x 1")
PY
/usr/bin/python3 clips.py >seen 2>messages || { tail -n 3 messages; exit 1; }
expect_in seen <<'END'
bar from 10 to 190 mm clipped by nothing: picture 10 to 190 mm, SVG 10 to 190 mm
bar from 10 to 190 mm clipped by rectangle: picture 80 to 120 mm, SVG 10 to 190 mm
bar from 10 to 190 mm clipped by circle: picture 80 to 120 mm, SVG 10 to 190 mm
hatch: tiles of 8 x 8 units with 8 squares of 1 x 1
END
