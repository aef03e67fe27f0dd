#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# offset-polygon 0.9.2 (npm), for clearances and cutters: it makes smaller what it is to make larger if the corners run clockwise (y up), gives no
# numbers if the last corner repeats the first, as GeoJSON and most exporters of outlines have it, and turns what is too narrow inside out: a
# square of 10 by -6 is one of 2, by -12 one of 14. Nothing is said; its page promises that "positive values will create add margin, and
# negative padding". Believed: 14 and 6 from either side, closed or not, and nothing.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages offset-polygon@0.9.2
cat >offsets.mjs <<'JS'
import offsetPolygon from 'offset-polygon';
const told = (points) => {
  const x = points.map((point) => point.x);
  return points.length ? `${Math.min(...x)} to ${Math.max(...x)}` : 'nothing';
};
const square = [[0, 0], [10, 0], [10, 10], [0, 10]], closed = [...square, square[0]];
const offset = (points, distance) => told(offsetPolygon(points.map(([x, y]) => ({ x, y })), distance));
for (const distance of [2, -2, -6, -12])
  console.log(`by ${distance}: ${offset(square, distance)}; clockwise ${offset([...square].reverse(), distance)}; closed ${offset(closed, distance)}`);
JS
node offsets.mjs >seen
expect_in seen <<'END'
by 2: -2 to 12; clockwise 2 to 8; closed NaN to NaN
by -2: 2 to 8; clockwise -2 to 12; closed NaN to NaN
by -6: 4 to 6; clockwise -6 to 16; closed NaN to NaN
by -12: -2 to 12; clockwise -12 to 22; closed NaN to NaN
END
