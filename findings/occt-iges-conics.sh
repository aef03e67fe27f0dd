#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 reads conic arcs of IGES (104) right only if their axis is along x: an ellipse that is longer along y is drawn along x, a parabola that opens up or down is
# elsewhere and half as long again, a hyperbola that opens up is elsewhere, and one that opens to the left is drawn on the right. It says nothing, and ends
# with success. Ellipses along x, and parabolas and hyperbolas that open to the right, are right. Believed: the curves of the equation (IGES 5.3,
# 4.4, which has parameters for both axes).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
iges_curves
cat >iges.py <<'PY'
import math

from iges_curves import read, write

# A, B, C, D, E and F of A x2 + B x y + C y2 + D x + E y + F = 0, the height, and where the arc begins and ends.
c, s = math.cosh(1), math.sinh(1)
for what, form, values, right in (
        ("quarter of an ellipse, 20 along x", 1, (1 / 400, 0, 1 / 100, 0, 0, -1, 0, 20, 0, 0, 10), "within 0 0 to 20 10, 24.2 long"),
        ("quarter of an ellipse, 20 along y", 1, (1 / 100, 0, 1 / 400, 0, 0, -1, 0, 10, 0, 0, 20), "within 0 0 to 10 20, 24.2 long"),
        ("parabola to the right", 3, (0, 0, 1, -20, 0, 0, 0, 0, 0, 20, 20), "within 0 0 to 20 20, 29.6 long"),
        ("parabola to the left", 3, (0, 0, 1, 20, 0, 0, 0, 0, 0, -20, 20), "within -20 0 to 0 20, 29.6 long"),
        ("parabola upwards", 3, (1, 0, 0, 0, -20, 0, 0, 0, 0, 20, 20), "within 0 0 to 20 20, 29.6 long"),
        ("parabola downwards", 3, (1, 0, 0, 0, 20, 0, 0, 0, 0, 20, -20), "within 0 -20 to 20 0, 29.6 long"),
        ("hyperbola to the right", 2, (1 / 100, 0, -1 / 25, 0, 0, -1, 0, 10, 0, 10 * c, 5 * s), "within 10 0 to 15 6, 8.3 long"),
        ("hyperbola to the left", 2, (1 / 100, 0, -1 / 25, 0, 0, -1, 0, -10, 0, -10 * c, 5 * s), "within -15 0 to -10 6, 8.3 long"),
        ("hyperbola upwards", 2, (-1 / 25, 0, 1 / 100, 0, 0, -1, 0, 0, 10, 5 * s, 10 * c), "within 0 10 to 6 15, 8.3 long")):
    x1, y1, x2, y2 = values[7:]
    for x, y in ((x1, y1), (x2, y2)):
        assert abs(values[0] * x * x + values[2] * y * y + values[3] * x + values[4] * y + values[5]) < 1e-9, what
    write([(104, form, values, 0)])
    seen = read()
    print(f"{what}: {seen}" + ("" if seen == right else f"; right would be {right}"))
PY
python3 iges.py >seen
expect_in seen <<'END'
quarter of an ellipse, 20 along x: within 0 0 to 20 10, 24.2 long
quarter of an ellipse, 20 along y: within 0 0 to 20 10, 24.2 long; right would be within 0 0 to 10 20, 24.2 long
parabola to the right: within 0 0 to 20 20, 29.6 long
parabola to the left: within -20 0 to 0 20, 29.6 long
parabola upwards: within 0 -40 to 20 0, 46.5 long; right would be within 0 0 to 20 20, 29.6 long
parabola downwards: within 0 0 to 20 40, 46.5 long; right would be within 0 -20 to 20 0, 29.6 long
hyperbola to the right: within 10 0 to 15 6, 8.3 long
hyperbola to the left: within 10 0 to 15 6, 8.3 long; right would be within -15 0 to -10 6, 8.3 long
hyperbola upwards: within 22 10 to 32 15, 11.5 long; right would be within 0 10 to 6 15, 8.3 long
END
