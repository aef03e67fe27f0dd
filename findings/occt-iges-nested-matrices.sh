#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Open CASCADE 7.6.3 places what refers to a transformation matrix of IGES (124) by this alone, although the matrix refers to another one in turn: a line that the first
# turns and the second moves is turned only. Nothing is said. Believed: the product of both (IGES 5.3, 4.21: matrices are concatenated).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libocct-data-exchange-dev=7.6.3+dfsg1-7 libocct-ocaf-dev=7.6.3+dfsg1-7
iges_curves
cat >iges.py <<'PY'
from iges_curves import read, write

MOVE = (1, 0, 0, 5, 0, 1, 0, 6, 0, 0, 1, 0)
TURN = (0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0)
BOTH = (0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 0)
for what, curve in (("line", (110, 0, (10, 0, 0, 10, 20, 0))), ("quarter of a circle", (100, 0, (0, 0, 0, 10, 0, 0, 10)))):
    write([(124, 0, BOTH, 0), (*curve, 1)])
    right = read()
    write([(124, 0, MOVE, 0), (124, 0, TURN, 1), (*curve, 2)])
    seen = read()
    print(f"{what}, by one matrix: {right}; by one of another: {seen}")
PY
python3 iges.py >seen
expect_in seen <<'END'
line, by one matrix: within -15 16 to 5 16, 20.0 long; by one of another: within -20 10 to 0 10, 20.0 long
quarter of a circle, by one matrix: within -5 6 to 5 16, 15.7 long; by one of another: within -10 0 to 0 10, 15.7 long
END
