#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# point-in-svg-path 1.0.2 (npm) says of points within an outline that they lie outside if a corner, or the end of an arc, is as high as they are: within
# a circle of radius 50 at (50, 50) each point on the right of the middle and those at the left end, within a square that stands on a corner the right half.
# A tenth of a millimetre higher or lower it is right. It says nothing. Believed: within is within, as for holes (evenodd), of which it is right.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages point-in-svg-path@1.0.2
cat >points.js <<'JS'
const { pointInSvgPath } = require('point-in-svg-path');
for (const [name, path, points] of [
  ['circle', 'M0 50A50 50 0 1 1 100 50A50 50 0 1 1 0 50Z', [[5, 50], [25, 50], [75, 50], [95, 50], [105, 50], [5, 50.1], [95, 49.9]]],
  ['square on a corner', 'M0 50L50 0L100 50L50 100Z', [[20, 50], [80, 50], [80, 50.1]]],
  ['notch down to 50 50', 'M0 0L50 50L100 0V100H0Z', [[20, 49], [20, 50], [20, 51], [80, 50]]],
  ['plate with a hole', 'M0 0H100V100H0ZM30 30H70V70H30Z', [[50, 50], [15, 50]]]])
  for (const [x, y] of points) console.log(`${name}: ${x} ${y} is ${pointInSvgPath(path, x, y) ? 'within' : 'outside'}`);
JS
node points.js >seen
expect_in seen <<'END'
circle: 5 50 is outside
circle: 25 50 is within
circle: 75 50 is outside
circle: 95 50 is outside
circle: 105 50 is outside
circle: 5 50.1 is within
circle: 95 49.9 is within
square on a corner: 20 50 is within
square on a corner: 80 50 is outside
square on a corner: 80 50.1 is within
notch down to 50 50: 20 49 is within
notch down to 50 50: 20 50 is outside
notch down to 50 50: 20 51 is within
notch down to 50 50: 80 50 is within
plate with a hole: 50 50 is outside
plate with a hole: 15 50 is within
END
