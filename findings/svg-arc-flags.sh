#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The two flags of an SVG arc need no separators: "a30 30 0 1160 0" is "a 30 30 0 1 1 60 0" (grammar of SVG 1.1 and 2). svgpath reads
# it; makerjs 0.19.2 makes coordinates that are no numbers, and @jscad/svg-deserializer 2.5.14 one point, both without an error.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages makerjs@0.19.2 svgpath@2.6.0 @jscad/svg-deserializer@2.5.14 @jscad/modeling@2.13.0
cat >flags.cjs <<'JS'
const makerjs = require('makerjs');
const { deserialize } = require('@jscad/svg-deserializer');
const { measureBoundingBox } = require('@jscad/modeling').measurements;
const number = x => (x === undefined || Number.isNaN(x) ? 'NaN' : x.toFixed(1));
for (const path of ['M20 50a30 30 0 1 1 60 0', 'M20 50a30 30 0 1160 0']) {
  console.log('svgpath', require('svgpath')(path).abs().toString());
  const box = makerjs.measure.modelExtents(makerjs.importer.fromSVGPathData(path));
  console.log('makerjs x', number(box.low[0]), number(box.high[0]));
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><path fill="none" stroke="#000" d="${path}"/></svg>`;
  const [low, high] = measureBoundingBox([].concat(deserialize({ output: 'geometry', addMetaData: false }, svg))[0]);
  console.log('jscad x', number(low[0]), number(high[0]));
}
JS
node flags.cjs >seen
expect_in seen <<'END'
svgpath M20 50A30 30 0 1 1 80 50
makerjs x 20.0 80.0
jscad x 20.0 80.0
svgpath M20 50A30 30 0 1 1 80 50
makerjs x NaN NaN
jscad x 20.0 20.0
END
