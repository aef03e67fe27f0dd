#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/modeling 2.13.0: offset by more than half of a width does not empty a shape: a square of 10 by -6 is one of 2, by -8 one of 6, an angle
# with legs of 5 by -3 has a negative area, and of two squares of 10 joined by a bar of 2, by -2, what was the bar is taken off: 44 instead of 72. So
# clearances and tool paths are wrong where a part is narrow. Believed: what is narrower vanishes, as with other offsets.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/modeling@2.13.0
cat >offsets.cjs <<'JS'
const { primitives: { square, polygon }, expansions: { offset }, measurements: { measureArea } } = require("@jscad/modeling");
const angle = polygon({ points: [[0, 0], [20, 0], [20, 5], [5, 5], [5, 20], [0, 20]] });
const two = polygon({ points: [[0, 0], [10, 0], [10, 4], [20, 4], [20, 0], [30, 0], [30, 10], [20, 10], [20, 6], [10, 6], [10, 10], [0, 10]] });
const say = (what, shape, delta, right) => console.log(`${what} by ${delta}: ${measureArea(offset({ delta }, shape)).toFixed(1)}, right would be ${right}`);
say("square of 10", square({ size: 10 }), -2, 36);
say("square of 10", square({ size: 10 }), -6, 0);
say("square of 10", square({ size: 10 }), -8, 0);
say("angle with legs of 5", angle, -2, 31);
say("angle with legs of 5", angle, -3, 0);
say("two squares of 10 joined by 2", two, -0.5, 173);
say("two squares of 10 joined by 2", two, -2, 72);
JS
node offsets.cjs >seen
expect_in seen <<'END'
square of 10 by -2: 36.0, right would be 36
square of 10 by -6: 4.0, right would be 0
square of 10 by -8: 36.0, right would be 0
angle with legs of 5 by -2: 31.0, right would be 31
angle with legs of 5 by -3: -29.0, right would be 0
two squares of 10 joined by 2 by -0.5: 173.0, right would be 173
two squares of 10 joined by 2 by -2: 44.0, right would be 72
END
