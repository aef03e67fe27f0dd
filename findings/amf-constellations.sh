#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# three 0.187.0 (AMFLoader) and @jscad/amf-deserializer 2.3.13 read of an AMF its objects and not its constellations, by which ISO/ASTM 52915
# places them: of an assembly of three plates, two of them turned or moved, there is one plate at the origin. Nothing is said. JSCAD takes
# an inch for 25.40005 mm. Believed: three plates at their places, as the element "instance" says, and 25.4 mm.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three@0.187.0 jsdom@29.1.1 @jscad/amf-deserializer@2.3.13 @jscad/modeling@2.13.0
cat >read.mjs <<'JS'
import { createRequire } from 'module';
import { JSDOM } from 'jsdom';
import { Box3 } from 'three';
import { AMFLoader } from 'three/addons/loaders/AMFLoader.js';

globalThis.DOMParser = new JSDOM().window.DOMParser;
console.log = () => {};  // what the loader says of the unit
const require = createRequire(import.meta.url);
const { deserialize } = require('@jscad/amf-deserializer');
const { measureAggregateBoundingBox } = require('@jscad/modeling').measurements;

const facets = '0 2 3,0 3 1,4 5 7,4 7 6,0 1 5,0 5 4,2 6 7,2 7 3,0 4 6,0 6 2,1 3 7,1 7 5'.split(',').map((facet) => facet.split(' '));
const vertices = [...Array(8).keys()].map((i) => `<vertex><coordinates><x>${30 * (i & 1)}</x><y>${20 * (i >> 1 & 1)}</y><z>${10 * (i >> 2)}</z></coordinates></vertex>`);
const plate = `<object id="1"><mesh><vertices>${vertices.join('')}</vertices><volume>${facets.map(([a, b, c]) => `<triangle><v1>${a}</v1><v2>${b}</v2><v3>${c}</v3></triangle>`).join('')}</volume></mesh></object>`;
const instance = (x, z, turn) => `<instance objectid="1"><deltax>${x}</deltax><deltay>0</deltay><deltaz>${z}</deltaz><rx>0</rx><ry>0</ry><rz>${turn}</rz></instance>`;
const placed = `<constellation id="2">${instance(0, 0, 0)}${instance(100, 0, 90)}${instance(0, 40, 0)}</constellation>`;
const amf = (unit, more) => `<?xml version="1.0" encoding="UTF-8"?><amf unit="${unit}" version="1.1">${plate}${more}</amf>`;
const upper = (values) => values.map((value) => value.toFixed(3)).join(' ');

for (const [what, text] of [['one plate', amf('millimeter', '')], ['three plates', amf('millimeter', placed)], ['inches', amf('inch', '')]]) {
  const group = new AMFLoader().parse(new TextEncoder().encode(text).buffer);
  group.updateMatrixWorld(true);
  const solids = [].concat(deserialize({ output: 'geometry', filename: 'plates.amf' }, text));
  process.stdout.write(`${what}: three ${group.children.length}, up to ${upper(new Box3().setFromObject(group).max.toArray())}; JSCAD ${solids.length}, up to ${upper(measureAggregateBoundingBox(solids)[1])}\n`);
}
JS
node read.mjs >seen
expect_in seen <<'END'
one plate: three 1, up to 30.000 20.000 10.000; JSCAD 1, up to 30.000 20.000 10.000
three plates: three 1, up to 30.000 20.000 10.000; JSCAD 1, up to 30.000 20.000 10.000
inches: three 1, up to 762.000 508.000 254.000; JSCAD 1, up to 762.002 508.001 254.001
END
