#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/svg-deserializer 2.5.14 cannot read what @jscad/svg-serializer 2.3.21 writes of a plate with a hole, or of two plates: "Malformed svg path".
# After that it reads no other file, either, until the process ends: each has the error of the first. As an outline (target geom2) a plate of 800
# comes as one of 400 whose box has no width. As a path a single outline is right. Believed: what one half of the pair writes the other half
# reads, and an error is that of its file.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/svg-deserializer@2.5.14 @jscad/svg-serializer@2.3.21 @jscad/modeling@2.13.0
cat >read.cjs <<'JS'
const { deserialize } = require('@jscad/svg-deserializer');
const { serialize } = require('@jscad/svg-serializer');
const { booleans: { subtract }, geometries: { path2 }, measurements: { measureArea, measureBoundingBox }, primitives: { circle, rectangle } } = require('@jscad/modeling');
const plate = rectangle({ size: [40, 20] }), drilled = subtract(plate, circle({ radius: 3 }));
const read = (name, shape, target) => {
  try {
    const [found] = [].concat(deserialize({ output: 'geometry', target }, serialize({ unit: 'mm' }, shape).join(''))).flat(Infinity);
    const [low, high] = measureBoundingBox(found).map((point) => point.map((value) => value.toFixed(1)));
    console.log(`${name}, ${target}: ${target === 'path' ? `${path2.toPoints(found).length} corners` : `area ${measureArea(found).toFixed(1)}`}, ${low.slice(0, 2)} to ${high.slice(0, 2)}`);
  } catch (error) {
    console.log(`${name}, ${target}: ${error.message}`);
  }
};
read('plate', plate, 'path');
read('plate', plate, 'geom2');
read('drilled plate', drilled, 'path');
read('plate again', plate, 'path');
JS
node read.cjs >seen
expect_in seen <<'END'
plate, path: 4 corners, 0.0,-20.0 to 40.0,0.0
plate, geom2: area 400.0, 0.0,-20.0 to 0.0,-20.0
drilled plate, path: Malformed svg path at 7:58. Path closed itself with command #4 L0 20
plate again, path: Malformed svg path at 7:58. Path closed itself with command #4 L0 20
END
