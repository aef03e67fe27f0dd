#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Many programs write "facet normal 0 0 0" and leave the normal to the order of the corners. @jscad/stl-deserializer 2.1.30 turns each such
# facet over: a box of 1000 has the volume -1000, and cut from one of 8000
# leaves 1000. Believed: 1000 and 7000, as with the normals that ADMesh 0.98.4 fills in.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/stl-deserializer@2.1.30 @jscad/modeling@2.13.0
debian_packages admesh=0.98.4-2
box_stl box 0 >zero.stl
admesh -a admesh.stl zero.stl >admesh.log
cat >volumes.cjs <<'JS'
const fs = require('fs');
const { deserialize } = require('@jscad/stl-deserializer');
const { booleans, measurements, primitives } = require('@jscad/modeling');
for (const file of ['admesh.stl', 'zero.stl']) {
  const box = [].concat(deserialize({ output: 'geometry', filename: file }, fs.readFileSync(file)))[0];
  const rest = booleans.subtract(primitives.cuboid({ size: [20, 20, 20], center: [10, 10, 10] }), box);
  console.log(`${file}: volume ${Math.round(measurements.measureVolume(box))}, cut from 8000: ${Math.round(measurements.measureVolume(rest))}`);
}
JS
{
  awk '/Volume/ { printf "ADMesh: volume %.0f\n", $NF }' admesh.log
  grep -m 1 normal zero.stl
  grep -m 1 normal admesh.stl
  node volumes.cjs
} >seen
expect_in seen <<'END'
ADMesh: volume 1000
 facet normal 0 0 0
  facet normal  0.00000000E+00  0.00000000E+00 -1.00000000E+00
admesh.stl: volume 1000, cut from 8000: 7000
zero.stl: volume -1000, cut from 8000: 1000
END
