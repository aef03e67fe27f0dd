#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# emf2svg 1.1.0 makes of an EMF other shapes: corners of round rectangles are twice as round, since it takes the width of a corner's ellipse for its
# radius; where y points up (a viewport of negative height) rectangles and ellipses get negative heights, which SVG has not, and arcs another
# radius; lines whose dashes the pen defines are continuous, so that hidden ones become visible, and pens of EMR_CREATEPEN have the width 1. It
# ends with success. With y down, and by EMR_EXTCREATEPEN without own dashes, all is right. Believed: as [MS-EMF] has it.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages emf2svg=1.1.0+ds-3
cat >emf.py <<'PY'
import struct

def record(kind, layout="", *values):
    return struct.pack("<II" + layout, kind, 8 + struct.calcsize("<" + layout), *values)

def emf(records):  # on a sheet of 100 mm, 400 pixels
    body = b"".join(records) + record(14, "III", 0, 16, 20)
    return record(1, "8iIIIIHHIIIiiii", 0, 0, 399, 399, 0, 0, 10000, 10000, 0x464D4520, 0x10000, 88 + len(body), len(records) + 2, 2, 0, 0, 0, 0, 1000, 1000, 250, 250) + body

def pen(width):
    return record(38, "IIiiI", 1, 0, width, 0, 0)

def geometric(width, *dashes):
    return record(95, f"{11 + len(dashes)}I", 1, 0, 0, 0, 0, 0x10007 if dashes else 0x10000, width, 0, 0, 0, len(dashes), *dashes)

LINE = [record(27, "ii", 40, 40), record(54, "ii", 340, 40)]
Y_UP = [record(17, "I", 8), record(9, "ii", 400, 400), record(10, "ii", 0, 400), record(11, "ii", 400, -400), record(12, "ii", 0, 0)]
RECTANGLE, ELLIPSE, ARC = record(43, "4i", 100, 100, 300, 200), record(42, "4i", 100, 100, 300, 200), record(45, "8i", 100, 100, 300, 300, 300, 200, 200, 300)
for name, start, shapes in (
    ("line, pen of 8", [pen(8)], LINE), ("line, geometric pen of 8", [geometric(8)], LINE), ("line, dashes of 20 and gaps of 10", [geometric(4, 20, 10)], LINE),
    ("rectangle 200 x 100", [pen(1)], [RECTANGLE]), ("rectangle, y up", [pen(1)] + Y_UP, [RECTANGLE]),
    ("rectangle, corners 40 x 20", [pen(1)], [record(44, "6i", 100, 100, 300, 200, 40, 20)]),
    ("ellipse 200 x 100", [pen(1)], [ELLIPSE]), ("ellipse, y up", [pen(1)] + Y_UP, [ELLIPSE]),
    ("arc of radius 100", [pen(1)], [ARC]), ("arc, y up", [pen(1)] + Y_UP, [ARC])):
    with open(name + ".emf", "wb") as file:
        file.write(emf(start + [record(37, "I", 1), record(37, "I", 0x80000005)] + shapes))
PY
python3 emf.py
for file in *.emf; do
  name=${file%.emf}
  emf2svg-conv -i "$file" -o "$name.svg"
  case $name in
    line*) what='stroke-width|stroke-dasharray' ;;
    *) what='width|height|rx|ry' ;;
  esac
  case $name in
    arc*) sed -nE 's/.*A ([-0-9.]+),([-0-9.]+) .*/rx="\1" ry="\2"/p' "$name.svg" ;;
    *) sed -n '/<g/,$p' "$name.svg" | grep -oE "(^| )($what)=\"[^\"]*\"" | paste -sd ' ' ;;
  esac | sed "s/^ */$name: /; s/  */ /g; s/\.0000//g"
done >seen
expect_in seen <<'END'
arc of radius 100: rx="100" ry="100"
arc, y up: rx="100" ry="300"
ellipse 200 x 100: rx="100" ry="50"
ellipse, y up: rx="100" ry="-50"
line, dashes of 20 and gaps of 10: stroke-width="4"
line, geometric pen of 8: stroke-width="8"
line, pen of 8: stroke-width="1"
rectangle 200 x 100: width="200" height="100"
rectangle, corners 40 x 20: width="200" height="100" rx="40" ry="20"
rectangle, y up: width="200" height="-100"
END
