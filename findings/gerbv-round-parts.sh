#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# gerbv 2.9.6 writes arcs of a Gerber (an outline of a board, a round pad) into SVG and PDF as curves of Bezier that stand for up to half a circle: the
# outline lies up to 0.35 mm, a whole point, outside of the circle, at a radius of 19 mm; a pad of a diameter of 20 mm is 0.18 mm off. Only larger
# arcs are divided. It says nothing. Believed: curves to the micrometre, as the numbers of the Gerber are.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages gerbv=2.9.6-1
cat >deviation.py <<'PY'
import math, re, sys
radius = float(sys.argv[1])
text = open("board.svg").read()
matrix = re.search(r"matrix\(([^)]*)\)", text)
scale = float(matrix[1].split(",")[0]) if matrix else 1
curves = []
for path in re.findall(r' d="([^"]*)"', text):
    words, here = path.split(), None
    while words:
        command = words.pop(0)
        if command in "ML":
            here = [float(words.pop(0)), float(words.pop(0))]
        elif command == "C":
            controls = [here] + [[float(words.pop(0)), float(words.pop(0))] for _ in range(3)]
            curves.append(controls)
            here = controls[3]
points = [[sum(w * c[axis] for w, c in zip(((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3), controls)) * scale * 25.4 / 72
           for axis in (0, 1)] for controls in curves for t in (i / 100 for i in range(101))]
ends = [[value * scale * 25.4 / 72 for value in controls[0]] for controls in curves]
middle = [(min(end[axis] for end in ends) + max(end[axis] for end in ends)) / 2 for axis in (0, 1)]
print(f"{sys.argv[2]} of radius {radius:g}: {len(curves)} curves, up to {max(math.dist(point, middle) for point in points) - radius:.2f} mm outside")
PY
gerber() {  # WHAT RADIUS APERTURE COMMANDS
  printf '%s\n' '%FSLAX46Y46*%' '%MOMM*%' "%ADD10C,$3*%" '%LPD*%' 'D10*' "$4" 'M02*' >board.gbr
  gerbv -x svg -o board.svg board.gbr >messages 2>&1
  python3 deviation.py "$2" "$1"
}
for radius in 1 5 10 15 19 20 50; do
  gerber outline "$radius" 0.2 "X0Y0D02*
G75*
G03*
X0Y0I${radius}000000J0D01*"
done >seen
for radius in 5 10; do gerber pad "$radius" $((2 * radius)) 'X0Y0D03*'; done >>seen
expect_in seen <<'END'
outline of radius 1: 2 curves, up to 0.02 mm outside
outline of radius 5: 2 curves, up to 0.09 mm outside
outline of radius 10: 2 curves, up to 0.18 mm outside
outline of radius 15: 2 curves, up to 0.28 mm outside
outline of radius 19: 2 curves, up to 0.35 mm outside
outline of radius 20: 4 curves, up to 0.01 mm outside
outline of radius 50: 4 curves, up to 0.01 mm outside
pad of radius 5: 2 curves, up to 0.09 mm outside
pad of radius 10: 2 curves, up to 0.18 mm outside
END
