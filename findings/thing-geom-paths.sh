#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @thi.ng/geom 8.0.1 reads smooth curves of SVG (S) without reflecting the control point, and begins an outline after z from the last corner, not the
# first. Arcs that it mirrored have a negative radius in its SVG, which SVG takes for a positive one, and bulge to the other side,
# though its own points of them are right; boxes of turned ellipses are too small. Believed: as SVG 1.1 has it (8.3.3, 8.3.6, F.6.6).
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @thi.ng/geom@8.0.1 svgpath@2.6.0 svg-path-properties@2.1.0
cat >paths.mjs <<'JS'
import { arc, asSvg, bounds, pathFromSvg, pointAt, scale } from '@thi.ng/geom';
import { svgPathProperties } from 'svg-path-properties';
import svgpath from 'svgpath';

const drawn = (shape) => asSvg(shape).match(/d="(.*?)"/)[1];
for (const [name, d] of [['smooth after smooth (T)', 'M0 0q5 10 10 0t10 0'], ['smooth curve (S)', 'M0 0c0 10 10 10 10 0s10 -10 10 0'], ['hole after z', 'm0 0h20v20h-20zm5 5h10v10h-10z']])
  console.log(`${name}: ${drawn(pathFromSvg(d))}, svgpath ${svgpath(d).abs().unshort()}`);
for (const factors of [[1, 1], [2, 1], [-1, 1], [1, -1]]) {
  const shape = scale(arc([0, 0], 10, 0, 0, Math.PI / 2), factors), path = new svgPathProperties(drawn(shape));
  const { x, y } = path.getPointAtLength(path.getTotalLength() / 2);
  console.log(`quarter of a circle, scaled by ${factors}: ${drawn(shape)}, middle of this ${x.toFixed(1)} ${y.toFixed(1)}, of its arc ${pointAt(shape, 0.5).map((it) => it.toFixed(1)).join(' ')}`);
}
const { pos, size } = bounds(arc([0, 0], [10, 5], Math.PI / 6, 0, 2 * Math.PI));
console.log(`ellipse of 10 and 5 turned by 30 degrees: from ${pos.map((it) => it.toFixed(2)).join(' ')}, ${size.map((it) => it.toFixed(2)).join(' x ')}; right would be ` +
  `${(2 * Math.hypot(10 * Math.cos(Math.PI / 6), 5 * Math.sin(Math.PI / 6))).toFixed(2)} x ${(2 * Math.hypot(10 * Math.sin(Math.PI / 6), 5 * Math.cos(Math.PI / 6))).toFixed(2)}`);
JS
node paths.mjs >seen
expect_in seen <<'END'
smooth after smooth (T): M0,0Q5,10,10,0Q15,-10,20,0, svgpath M0 0Q5 10 10 0 15-10 20 0
smooth curve (S): M0,0C0,10,10,10,10,0C10,0,20,-10,20,0, svgpath M0 0C0 10 10 10 10 0 10-10 20-10 20 0
hole after z: M0,0H20V20H0V0zM5,25H15V35H5V25z, svgpath M0 0H20V20H0ZM5 5H15V15H5Z
quarter of a circle, scaled by 1,1: M10,0A10,10,0,0,1,0.000,10, middle of this 7.1 7.1, of its arc 7.1 7.1
quarter of a circle, scaled by 2,1: M20,0A20,10,0,0,1,0.000,10, middle of this 14.1 7.1, of its arc 14.1 7.1
quarter of a circle, scaled by -1,1: M-10,0A-10,10,0,0,1,-0.000,10, middle of this -2.9 2.9, of its arc -7.1 7.1
quarter of a circle, scaled by 1,-1: M10,0A10,-10,0,0,1,0.000,-10, middle of this 2.9 -2.9, of its arc 7.1 -7.1
ellipse of 10 and 5 turned by 30 degrees: from -8.66 -5.00, 17.32 x 10.00; right would be 18.03 x 13.23
END
