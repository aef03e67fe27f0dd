#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 reads an arc of IGES that a matrix mirrors (124 of form 1, as CAD programs write the left one of a pair) as the rest of its circle: a mirrored
# quarter becomes three quarters, whatever the axis, and so does a quarter of an ellipse. Nothing is said. Turned and half turned arcs, mirrored lines and mirrored
# splines are right. Believed: the points of the arc, mirrored (IGES 5.3, 4.3 and 4.21).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
iges_curves
cat >iges.py <<'PY'
import math

from iges_curves import read, write

ARC = (100, 0, (0, 0, 0, 10, 0, 0, 10), 2)
ELLIPSE = (104, 1, (1 / 400, 0, 1 / 100, 0, 0, -1, 0, 20, 0, 0, 10), 2)
LINE = (110, 0, (0, 0, 0, 10, 5, 0), 2)
w = math.sqrt(0.5)
SPLINE = (126, 0, (2, 2, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, w, 1, 10, 0, 0, 10, 10, 0, 0, 10, 0, 0, 1, 0, 0, 1), 2)
for what, curve, (x, y, z), right in (
        ("quarter of a circle", ARC, (1, 1, 1), "within 0 0 to 10 10, 15.7 long"), ("the same, turned half about z", ARC, (-1, -1, 1), "within -10 -10 to 0 0, 15.7 long"),
        ("the same, turned half about x", ARC, (1, -1, -1), "within 0 -10 to 10 0, 15.7 long"), ("mirrored in x", ARC, (-1, 1, 1), "within -10 0 to 0 10, 15.7 long"),
        ("mirrored in y", ARC, (1, -1, 1), "within 0 -10 to 10 0, 15.7 long"), ("mirrored in z", ARC, (1, 1, -1), "within 0 0 to 10 10, 15.7 long"),
        ("quarter of an ellipse, mirrored in x", ELLIPSE, (-1, 1, 1), "within -20 0 to 0 10, 24.2 long"),
        ("quarter of a circle as a spline, mirrored in x", SPLINE, (-1, 1, 1), "within -10 0 to 0 10, 15.7 long"),
        ("line, mirrored in x", LINE, (-1, 1, 1), "within -10 0 to 0 5, 11.2 long")):
    write([(124, 1 if x * y * z < 0 else 0, (x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0), 0), (*curve[:3], 1)])
    seen = read()
    print(f"{what}: {seen}" + ("" if seen == right else f"; right would be {right}"))
PY
python3 iges.py >seen
expect_in seen <<'END'
quarter of a circle: within 0 0 to 10 10, 15.7 long
the same, turned half about z: within -10 -10 to 0 0, 15.7 long
the same, turned half about x: within 0 -10 to 10 0, 15.7 long
mirrored in x: within -10 -10 to 10 10, 47.1 long; right would be within -10 0 to 0 10, 15.7 long
mirrored in y: within -10 -10 to 10 10, 47.1 long; right would be within 0 -10 to 10 0, 15.7 long
mirrored in z: within -10 -10 to 10 10, 47.1 long; right would be within 0 0 to 10 10, 15.7 long
quarter of an ellipse, mirrored in x: within -20 -10 to 20 10, 72.7 long; right would be within -20 0 to 0 10, 24.2 long
quarter of a circle as a spline, mirrored in x: within -10 0 to 0 10, 15.7 long
line, mirrored in x: within -10 0 to 0 5, 11.2 long
END
