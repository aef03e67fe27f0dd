#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Cairo 1.16.0 keeps coordinates to 1/256 and curves to 0.1 of a unit in SVG, too, whatever that unit is (set_document_unit): on a sheet in centimetres or
# inches a circle of radius 50 mm becomes two curves, 0.9 mm out of round, and a line at 10.3 mm stands at 10.319. In points and millimetres
# it is 0.014 mm and 0.001. Nothing in the manual says so. Believed: a vector format keeps the doubles that it is given. A tolerance
# of a thousandth of a millimetre (set_tolerance) makes the circle as round as coordinates allow.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-cairo=1.20.1-5+b1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >units.py <<'PY'
import cairo, math, re

def points(path):
    words, current = iter(path.split()), None
    for word in words:
        if word in "MLC":
            ends = [(float(next(words)), float(next(words))) for _ in range(3 if word == "C" else 1)]
            for t in (k / 64 for k in range(65)) if word == "C" else ():
                yield [sum(w * p[i] for w, p in zip(((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3), (current, *ends))) for i in (0, 1)]
            current = ends[-1]
            yield current

print("Cairo", cairo.cairo_version_string())
for name, mm in (("PT", 25.4 / 72), ("MM", 1), ("CM", 10), ("IN", 25.4)):
    for tolerance in (None, 0.001):
        surface = cairo.SVGSurface("sheet.svg", 200 / mm, 200 / mm)
        surface.set_document_unit(getattr(cairo.SVGUnit, name))
        page = cairo.Context(surface)
        page.set_line_width(0.25 / mm)
        if tolerance:
            page.set_tolerance(tolerance / mm)
        page.arc(100 / mm, 100 / mm, 50 / mm, 0, 2 * math.pi)
        page.stroke()
        page.move_to(10 / mm, 10.3 / mm)
        page.line_to(100 / mm, 10.3 / mm)
        page.stroke()
        surface.finish()
        circle, line = re.findall(' d="([^"]*)"', open("sheet.svg").read())
        radii = [math.hypot(x * mm - 100, y * mm - 100) for x, y in points(circle)]
        print(f"{name}, tolerance {tolerance or 'not set'}: radius {min(radii):.3f} to {max(radii):.3f} mm in {circle.count('C')} curves, line at {next(points(line))[1] * mm:.3f} mm")
PY
python3 units.py >seen
expect_in seen <<'END'
Cairo 1.16.0
PT, tolerance not set: radius 49.999 to 50.014 mm in 4 curves, line at 10.299 mm
PT, tolerance 0.001: radius 49.999 to 50.002 mm in 6 curves, line at 10.299 mm
MM, tolerance not set: radius 49.999 to 50.013 mm in 4 curves, line at 10.301 mm
MM, tolerance 0.001: radius 50.000 to 50.002 mm in 6 curves, line at 10.301 mm
CM, tolerance not set: radius 50.000 to 50.920 mm in 2 curves, line at 10.312 mm
CM, tolerance 0.001: radius 50.000 to 50.014 mm in 4 curves, line at 10.312 mm
IN, tolerance not set: radius 49.994 to 50.940 mm in 2 curves, line at 10.319 mm
IN, tolerance 0.001: radius 49.970 to 50.029 mm in 4 curves, line at 10.319 mm
END
