#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-path-to-polygons 0.1.0 draws the second of two smooth curves (S after S) elsewhere: it reflects the control point of a C only. A path with
# a quadratic curve or an arc, which its README says are still to be supported, ends the whole program with status 2 instead of an error
# that one can catch. Believed: S after S as after C (SVG 1.1, 8.3.6), and an exception.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-path-to-polygons@0.1.0
cat >polygons.cjs <<'JS'
const { pathDataToPolys } = require('svg-path-to-polygons');
for (const [name, d] of [['three C', 'M0 0C0 10 10 10 10 0C10 -10 20 -10 20 0C20 10 30 10 30 0'], ['C, S, S', 'M0 0C0 10 10 10 10 0S20 -10 20 0S30 10 30 0']]) {
  const [points] = pathDataToPolys(d, { tolerance: 0.001 });
  console.log(`${name}: highest between 20 and 30 at ${Math.max(...points.filter(([x]) => x > 20).map(([, y]) => y)).toFixed(2)}`);
}
try {
  pathDataToPolys('M0 0A10 10 0 0 1 20 0');
} catch (error) {
  console.log('an arc: caught');
}
console.log('after the arc');
JS
{ node polygons.cjs 2>&1 || echo "ended with status $?"; } >seen
expect_in seen <<'END'
three C: highest between 20 and 30 at 7.50
C, S, S: highest between 20 and 30 at 4.44
Our deepest apologies, but elliptical arc commands (A) are not yet supported.
ended with status 2
END
