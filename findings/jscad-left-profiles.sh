#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/modeling 2.13.0: extrudeRotate of a profile on the left of the axis (negative x) gives a body inside out: a ring of 125 mm3 has -125, its
# facets in STL look inwards, and cut from a block of 4000 it leaves the ring instead of the block without it. On the right all is right.
# Nothing is said. Believed: the same ring from either side.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/modeling@2.13.0 @jscad/stl-serializer@2.1.23
cat >left.cjs <<'JS'
const { primitives: { square, cuboid }, extrusions: { extrudeRotate }, booleans: { subtract, union }, measurements: { measureVolume } } = require("@jscad/modeling");
const { serialize } = require("@jscad/stl-serializer");
const volumeOfStl = (body) => {
  const numbers = [...serialize({ binary: false }, body).join("").matchAll(/vertex (\S+) (\S+) (\S+)/g)].map((found) => found.slice(1).map(Number));
  let volume = 0;
  for (let i = 0; i < numbers.length; i += 3) {
    const [a, b, c] = numbers.slice(i, i + 3);
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  return volume;
};
const block = cuboid({ size: [20, 20, 10] });
for (const [side, x] of [["right", 5], ["left", -5]]) {
  const ring = extrudeRotate({ segments: 64 }, square({ size: 2, center: [x, 0] }));
  const volumes = [measureVolume(ring), volumeOfStl(ring), measureVolume(subtract(block, ring)), measureVolume(union(block, ring))];
  console.log(`${side}: ring ${volumes[0].toFixed(0)}, in STL ${volumes[1].toFixed(0)}, block without it ${volumes[2].toFixed(0)}, with it ${volumes[3].toFixed(0)}`);
}
JS
node left.cjs >seen
expect_in seen <<'END'
right: ring 125, in STL 125, block without it 3875, with it 4000
left: ring -125, in STL -125, block without it 125, with it 0
END
