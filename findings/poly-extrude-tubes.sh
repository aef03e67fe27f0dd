#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# poly-extrude 0.16.0 (npm, for three.js and maptalks) makes tubes along a path (expandTubes) that have no width at all where the path goes straight up,
# and at a corner of 90 degrees are 1.41 times as high as wide, or as wide as high in an upright plane, since it stretches the section all around
# instead of in the plane of the bend. It says nothing. Straight level or slanted tubes are right. Believed: round tubes of the radius asked for.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages poly-extrude@0.16.0
cat >tubes.js <<'JS'
const { expandTubes } = require('poly-extrude');
for (const [name, path] of [
  ['level', [[0, 0, 0], [10, 0, 0]]], ['level, three points', [[0, 0, 0], [5, 0, 0], [10, 0, 0]]], ['straight up', [[0, 0, 0], [0, 0, 10]]],
  ['up by 45 degrees', [[0, 0, 0], [10, 0, 10]]], ['level, then straight up', [[0, 0, 0], [10, 0, 0], [10, 0, 10]]],
  ['level corner of 45 degrees', [[0, 0, 0], [10, 0, 0], [20, 10, 0]]], ['level corner of 90 degrees', [[0, 0, 0], [10, 0, 0], [10, 10, 0]]]]) {
  const { position } = expandTubes([path], { radius: 1, radialSegments: 32 });
  const box = [0, 1, 2].map((axis) => {
    const values = [...position].filter((_, i) => i % 3 === axis);
    return `${(Math.min(...values) + 0).toFixed(2)}..${Math.max(...values).toFixed(2)}`.replace('-0.00', '0.00');
  });
  console.log(`${name}: ${box.join(' ')}`);
}
JS
node tubes.js >seen
expect_in seen <<'END'
level: 0.00..10.00 -1.00..1.00 -1.00..1.00
level, three points: 0.00..10.00 -1.00..1.00 -1.00..1.00
straight up: 0.00..0.00 0.00..0.00 0.00..10.00
up by 45 degrees: -0.71..10.71 -1.00..1.00 -0.71..10.71
level, then straight up: 0.00..11.00 -1.41..1.41 -1.00..10.00
level corner of 45 degrees: 0.00..20.71 -1.00..10.71 -1.08..1.08
level corner of 90 degrees: 0.00..11.00 -1.00..10.00 -1.41..1.41
END
