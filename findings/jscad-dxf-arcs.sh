#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/dxf-deserializer 2.3.30: an ARC that crosses the angle 0 (350 to 10 degrees) becomes points that are no numbers, and the
# extrusion direction (0, 0, -1), which mirrors an ARC, is not heeded: it lies at x -20..-10 instead of 10..20.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/dxf-deserializer@2.3.30 @jscad/modeling@2.13.0
cat >arcs.cjs <<'JS'
const { deserialize } = require('@jscad/dxf-deserializer');
const { measureBoundingBox } = require('@jscad/modeling').measurements;
const arc = (x, from, to, up) => ['0', 'SECTION', '2', 'ENTITIES', '0', 'ARC', '8', '0', '10', x, '20', '0', '30', '0', '40', '10',
  '210', '0', '220', '0', '230', up, '50', from, '51', to, '0', 'ENDSEC', '0', 'EOF', ''].join('\n');
for (const [name, text] of [['from 0 to 90', arc(0, 0, 90, 1)], ['from 350 to 10', arc(0, 350, 10, 1)], ['mirrored', arc(-20, 0, 90, -1)]]) {
  const [low, high] = measureBoundingBox([].concat(deserialize({ output: 'geometry' }, text))[0]);
  console.log(`${name}: x ${low[0].toFixed(2)} to ${high[0].toFixed(2)}`);
}
JS
node arcs.cjs >seen
expect_in seen <<'END'
from 0 to 90: x 0.00 to 10.00
from 350 to 10: x NaN to NaN
mirrored: x -20.00 to -10.00
END
