#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# point-at-length 1.1.0 (npm) takes the arcs of an SVG path for nothing: a half circle of radius 10 has the length 0, all its points are its
# beginning, and a line after it begins there, so that the length of a slot is 48.3 instead of 102.8. Its page names no limits, and nothing is
# said. Curves and lines are right to their chords. Believed: as svg-path-properties 2.1.0, which measures arcs, too.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages point-at-length@1.1.0 svg-path-properties@2.1.0
cat >lengths.cjs <<'JS'
const pointAtLength = require('point-at-length');
const { svgPathProperties } = require('svg-path-properties');
for (const path of ['M0 0H10', 'M0 0C0 10 10 10 10 0', 'M10 0A10 10 0 0 1 -10 0', 'M0 0H20A10 10 0 0 1 20 20H0A10 10 0 0 1 0 0']) {
  const other = new svgPathProperties(path), here = pointAtLength(path), half = other.getTotalLength() / 2;
  const there = other.getPointAtLength(half);
  console.log(`${path}: ${here.length().toFixed(1)} long, ${here.at(half).map((value) => value.toFixed(1)).join(' ')} at half; `
    + `right ${(2 * half).toFixed(1)}, ${there.x.toFixed(1)} ${there.y.toFixed(1)}`);
}
JS
node lengths.cjs >seen
expect_in seen <<'END'
M0 0H10: 10.0 long, 5.0 0.0 at half; right 10.0, 5.0 0.0
M0 0C0 10 10 10 10 0: 20.0 long, 5.0 7.5 at half; right 20.0, 5.0 7.5
M10 0A10 10 0 0 1 -10 0: 0.0 long, 10.0 0.0 at half; right 31.4, 0.0 10.0
M0 0H20A10 10 0 0 1 20 20H0A10 10 0 0 1 0 0: 48.3 long, 0.0 20.0 at half; right 102.8, 20.0 20.0
END
