#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svgelements 1.7.2 (below vpype and MeerK40t, for plotters and laser cutters) transforms arcs wrongly unless both axes keep their angle:
# a circle of 10 skewed, as on an isometric face, becomes another ellipse, or stays a circle; its box is wrong, too. A line is right. An arc
# with the radius 0, which is a line (SVG 1.1, F.6.2), has the length 0. Nothing is said. Believed: as each point moves.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages python3-svgelements=1.7.2-2
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >arcs.py <<'PY'
import math
from svgelements import SVG, Matrix, Path

def box(points):
    return " ".join(f"{min(values):.2f}..{max(values):.2f}" for values in zip(*points))

for name in ("scale(2 1)", "rotate(30)", "rotate(30) scale(2 1)", "scale(2 1) rotate(30)", "skewX(30)", "matrix(0.866 0.5 -0.866 0.5 0 0)"):
    with open("circle.svg", "w") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100"><circle r="10" transform="{name}"/></svg>')
    circle = abs(Path(next(element for element in SVG.parse("circle.svg").elements() if "Circle" in type(element).__name__)))
    seen = [circle.point(k / 720) for k in range(720)]
    m = Matrix(name)
    angles = [k * math.pi / 360 for k in range(720)]
    right = [(10 * (m.a * math.cos(t) + m.c * math.sin(t)), 10 * (m.b * math.cos(t) + m.d * math.sin(t))) for t in angles]
    print(f"{name}: points within {box([(p.x, p.y) for p in seen])}; should be {box(right)}")
print("length of an arc of radius 0 from 0 to 10:", Path("M0 0A0 5 0 0 1 10 0").length())
PY
/usr/bin/python3 arcs.py >seen
expect_in seen <<'END'
scale(2 1): points within -20.00..20.00 -10.00..10.00; should be -20.00..20.00 -10.00..10.00
rotate(30): points within -10.00..10.00 -10.00..10.00; should be -10.00..10.00 -10.00..10.00
rotate(30) scale(2 1): points within -18.03..18.03 -13.23..13.23; should be -18.03..18.03 -13.23..13.23
scale(2 1) rotate(30): points within -17.70..17.70 -13.66..13.66; should be -20.00..20.00 -10.00..10.00
skewX(30): points within -10.00..10.00 -11.55..11.55; should be -11.55..11.55 -10.00..10.00
matrix(0.866 0.5 -0.866 0.5 0 0): points within -10.00..10.00 -10.00..10.00; should be -12.25..12.25 -7.07..7.07
length of an arc of radius 0 from 0 to 10: 0
END
