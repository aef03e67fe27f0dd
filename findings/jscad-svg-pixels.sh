#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/svg-deserializer 2.5.14: a length in px, or without a unit, is 25.4/90 mm, and not 25.4/96 as CSS has it: a drawing of
# 96 by 96 px, one inch, is 27.09 mm wide. Believed: SVG is read at 96 px per inch.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/svg-deserializer@2.5.14 @jscad/modeling@2.13.0
cat >pixels.cjs <<'JS'
const { deserialize } = require('@jscad/svg-deserializer');
const { measureBoundingBox } = require('@jscad/modeling').measurements;
const width = (side, unit) => {
  const text = `<svg xmlns="http://www.w3.org/2000/svg" width="${side}${unit}" height="${side}${unit}" viewBox="0 0 ${side} ${side}"><rect width="${side}" height="${side}"/></svg>`;
  const [low, high] = measureBoundingBox([].concat(deserialize({ output: 'geometry', addMetaData: false }, text))[0]);
  return (high[0] - low[0]).toFixed(2);
};
console.log(`96 px: ${width(96, 'px')} mm; 96: ${width(96, '')} mm; 25.4 mm: ${width(25.4, 'mm')} mm`);
JS
node pixels.cjs >seen
expect_in seen <<'END'
96 px: 27.09 mm; 96: 27.09 mm; 25.4 mm: 25.40 mm
END
