#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Printrun 2.0.0rc8 (gcoder, by which Pronterface and scripts tell how large a print is and how long it takes) knows arcs (G2, G3) by their ends only: a
# ring of 80 mm has no width, a half ring no depth, and neither takes any time. It takes the steps of relative moves (G91) for places: an L of
# 40 mm is 50 deep, and takes half of its time. Moves as G01, or coordinates alone that go on with the last G1, are left out of size,
# time and filament. Nothing is said. The same ring of straight moves is right. Believed: what firmware of printers makes of them.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages printrun=2.0.0~rc8-2
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >measure.py <<'PY'
import math
from printrun.gcoder import GCode

chords = [f"G1 X{50 - 40 * math.cos(math.radians(a)):.3f} Y{50 + 40 * math.sin(math.radians(a)):.3f} E{a / 72:.3f}" for a in range(5, 361, 5)]
for what, lines in (("a ring of chords", ["G1 X10 Y50 F600", *chords]), ("a ring", ["G1 X10 Y50 F600", "G2 X10 Y50 I40 J0 E5"]),
                    ("half a ring", ["G1 X10 Y50 F600", "G2 X90 Y50 I40 J0 E2.5"]), ("an L", ["G1 X10 Y10 F600", "G1 X50 Y10 E2", "G1 X50 Y50 E4"]),
                    ("an L in steps", ["G1 X10 Y10 F600", "G91", "G1 X20 Y0 E1", "G1 X20 E1", "G1 Y20 E1", "G1 Y20 E1"]),
                    ("an L as G01", ["G01 X10 Y10 F600", "G01 X50 Y10 E2", "G01 X50 Y50 E4"]),
                    ("an L by coordinates", ["G1 X10 Y10 F600", "X50 Y10 E2", "X50 Y50 E4"])):
    print_ = GCode(["G21", "G90", "G28", "G1 Z0.2 F3000", *lines])
    print(f"{what}: {print_.width:.0f} x {print_.depth:.0f} mm, {print_.filament_length:.1f} mm of filament, {print_.estimate_duration()[1].seconds} s")
PY
python3 measure.py >seen
expect_in seen <<'END'
a ring of chords: 80 x 80 mm, 5.0 mm of filament, 30 s
a ring: 0 x 0 mm, 5.0 mm of filament, 5 s
half a ring: 80 x 0 mm, 2.5 mm of filament, 5 s
an L: 40 x 40 mm, 4.0 mm of filament, 9 s
an L in steps: 40 x 50 mm, 4.0 mm of filament, 5 s
an L as G01: 0 x 0 mm, 0.0 mm of filament, 0 s
an L by coordinates: 10 x 10 mm, 0.0 mm of filament, 1 s
END
