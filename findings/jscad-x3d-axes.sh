#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/x3d-serializer 2.4.13 turns what it writes, so that z becomes the y that points up in X3D, and @jscad/x3d-deserializer 2.2.13 does not
# turn it back: a block 30 high comes back lying. An outline comes back as a path of one point (as geometry; as a script it is whole). The
# option "unit" of the one and the statement "unit" of the other, which their pages promise, change nothing: 10 in, 10 mm and 10 m are 10.
# Nothing is said. Believed: what one half of the pair writes the other reads, and its page: lengths are "meters * conversionFactor".
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/x3d-serializer@2.4.13 @jscad/x3d-deserializer@2.2.13 @jscad/modeling@2.13.0
cat >axes.cjs <<'JS'
const { deserialize } = require('@jscad/x3d-deserializer');
const { serialize } = require('@jscad/x3d-serializer');
const { measurements: { measureBoundingBox }, primitives: { cuboid, rectangle }, geometries: { path2 } } = require('@jscad/modeling');
const written = (unit, shape) => serialize({ unit }, shape).join('');
const read = (text) => deserialize({ output: 'geometry' }, text).flat(Infinity);
const size = (shape) => { const [low, high] = measureBoundingBox(shape); return high.map((value, i) => (value - low[i]).toFixed(1)).join(' x '); };
const block = cuboid({ size: [10, 20, 30] });
console.log(`block of ${size(block)}: ${size(read(written('millimeter', block))[0])}`);
const body = (unit) => written(unit, block).replace(/.*created.*/, '');
console.log(`written in inches as in millimetres: ${body('inch') === body('millimeter')}`);
const [outline] = read(written('millimeter', rectangle({ size: [10, 20] })));
console.log(`rectangle: ${path2.toPoints(outline).length} points, ${outline.isClosed ? 'closed' : 'open'}`);
for (const [name, factor] of [['inch', 0.0254], ['millimeter', 0.001], ['metre', 1]])
  console.log(`10 x 20 x 30 read in ${name}: ${size(read(`<?xml version="1.0"?><X3D profile="Interchange" version="3.3">
    <head><unit category="length" name="${name}" conversionFactor="${factor}"/></head>
    <Scene><Shape><Box size="10 20 30"/></Shape></Scene></X3D>`)[0])}`);
JS
node axes.cjs >seen
expect_in seen <<'END'
block of 10.0 x 20.0 x 30.0: 10.0 x 30.0 x 20.0
written in inches as in millimetres: true
rectangle: 1 points, open
10 x 20 x 30 read in inch: 10.0 x 20.0 x 30.0
10 x 20 x 30 read in millimeter: 10.0 x 20.0 x 30.0
10 x 20 x 30 read in metre: 10.0 x 20.0 x 30.0
END
