#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# translate-svg-path 0.0.1 (npm) leaves a path where it is that begins by a relative m, as those of Inkscape do: of a plate and its hole, written in two
# ways, only one moves. scale-svg-path 0.0.1 multiplies the radii of turned ellipses that it stretches, so that they become others, and mirrors arcs to
# the side on which they are not. Nothing is said. Believed: moved and stretched as by a transform, as svgpath does.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages translate-svg-path@0.0.1 scale-svg-path@0.0.1 parse-svg-path@0.1.2 serialize-svg-path@0.1.0 svg-path-bbox@2.1.0 svgpath@2.6.0
cat >paths.js <<'JS'
const [translate, scale, parse, write, right] = ['translate-svg-path', 'scale-svg-path', 'parse-svg-path', 'serialize-svg-path', 'svgpath'].map(require);
const { svgPathBbox } = require('svg-path-bbox');
const box = (path) => svgPathBbox(path).map((value) => +value.toFixed(2) + 0).join(' ');
for (const path of ['M10 10h5v5z', 'm10 10h5v5z', 'm10 10 5 0 0 5z m1 1h2v2z'])
  console.log(`moved by 100 100: ${path} is within ${box(write(translate(parse(path), 100, 100)))}, right is ${box(right(path).translate(100, 100).toString())}`);
for (const [path, x, y] of [['M0 0A10 5 0 0 1 20 0', 2, 1], ['M0 0A10 5 30 0 1 20 0', 2, 1], ['M0 0A10 10 0 0 1 20 0', -1, 1], ['M0 0A10 10 0 0 1 20 0', 1, -1]])
  console.log(`scaled by ${x} ${y}: ${path} is within ${box(write(scale(parse(path), x, y)))}, right is ${box(right(path).scale(x, y).toString())}`);
JS
node paths.js >seen
expect_in seen <<'END'
moved by 100 100: M10 10h5v5z is within 110 110 115 115, right is 110 110 115 115
moved by 100 100: m10 10h5v5z is within 10 10 15 15, right is 110 110 115 115
moved by 100 100: m10 10 5 0 0 5z m1 1h2v2z is within 10 10 15 15, right is 110 110 115 115
scaled by 2 1: M0 0A10 5 0 0 1 20 0 is within 0 -5 40 0, right is 0 -5 40 0
scaled by 2 1: M0 0A10 5 30 0 1 20 0 is within -18.15 -23.75 40 0, right is -3.85 -8.75 40 0
scaled by -1 1: M0 0A10 10 0 0 1 20 0 is within -20 0 0 10, right is -20 -10 0 0
scaled by 1 -1: M0 0A10 10 0 0 1 20 0 is within 0 -10 20 0, right is 0 0 20 10
END
