#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# svg-flatten 1.0.1 (pathify, flatten, transform) joins the paths of a group as they are: one that begins by m, as Inkscape and SVGO write it,
# begins where the one before it ended. It makes square corners of round ones, and writes "undefined" and "NaN" for coordinates that are
# left out, which are 0 (SVG 1.1, 9). Transforms are right. Believed: the same outlines in one path.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages svg-flatten@1.0.1 svg-path-bbox@2.1.0
cat >flat.cjs <<'JS'
const flatten = require('svg-flatten'), { svgPathBbox } = require('svg-path-bbox');
for (const [name, right, shapes] of [
  ['two lines', '0 0 60 50', '<g><path d="M0 0h10"/><path d="M50 50h10"/></g>'],
  ['the second begins by m', '0 0 60 50', '<g><path d="M0 0h10"/><path d="m50 50h10"/></g>'],
  ['transforms in each other', '5 0 25 10', '<g transform="translate(5 0)"><path d="M0 0h10" transform="scale(2)"/><g transform="rotate(90)"><path d="M0 0h10"/></g></g>'],
  ['circle at the origin', '-10 -10 10 10', '<circle r="10"/>'],
  ['line from the origin', '0 0 10 5', '<line x2="10" y2="5"/>'],
  ['rectangle with round corners', 'with curves', '<rect width="10" height="5" rx="2"/>'],
]) {
  const seen = flatten(`<svg xmlns="http://www.w3.org/2000/svg">${shapes}</svg>`).pathify().flatten().transform().value().match(/ d="([^"]*)"/)[1];
  console.log(`${name}: ${/[Nu]/.test(seen) || right.startsWith('with') ? seen : 'box ' + svgPathBbox(seen).map((it) => +it.toFixed(3)).join(' ')}, should be ${right}`);
}
JS
node flat.cjs >seen
expect_in seen <<'END'
two lines: box 0 0 60 50, should be 0 0 60 50
the second begins by m: box 0 0 70 50, should be 0 0 60 50
transforms in each other: box 5 0 25 10, should be 5 0 25 10
circle at the origin: MNaN,undefineda10,10 0 1,0 20,0a10,10 0 1,0 -20,0, should be -10 -10 10 10
line from the origin: Mundefined,undefined 10,5, should be 0 0 10 5
rectangle with round corners: M0,0 10,0 10,5 0,5z, should be with curves
END
