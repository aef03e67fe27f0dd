#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# npm's three-dxf-loader 5.2.0 (three.js 0.160.0) draws what lies on a mirrored plane (an extrusion direction down, as CAD programs write circles and polylines
# seen from behind) unmirrored, in other places; it puts blocks off by their base point, one of an array, and draws what is off, frozen or on
# paper space. Of flat circles, whose z may be left out, it makes no numbers. It says nothing. Believed: the boxes that DXF's reference gives.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages three-dxf-loader@5.2.0 three@0.160.0
cat >read.mjs <<'JS'
import { Box3 } from 'three';
import { DXFLoader } from 'three-dxf-loader';
const line = '0 LINE 8 0 10 3 20 4 30 0 11 13 21 9 31 0';
const drawing = (entities) => `0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 2 0 LAYER 2 0 70 0 62 7 6 CONTINUOUS
  0 LAYER 2 OFF 70 0 62 -7 6 CONTINUOUS 0 LAYER 2 FROZEN 70 1 62 7 6 CONTINUOUS 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS
  0 BLOCK 8 0 2 PART 70 0 10 3 20 4 30 0 3 PART ${line} 0 ENDBLK 8 0 0 ENDSEC 0 SECTION 2 ENTITIES ${entities} 0 ENDSEC 0 EOF`.trim().split(/\s+/).join('\n') + '\n';
const down = '210 0 220 0 230 -1';
for (const [name, entities, right] of [
  ['a circle', '0 CIRCLE 8 0 10 5 20 0 30 0 40 2', '3 -2 to 7 2'],
  ['a circle without z', '0 CIRCLE 8 0 10 5 20 0 40 2', '3 -2 to 7 2'],
  ['a mirrored circle', `0 CIRCLE 8 0 10 5 20 0 30 0 40 2 ${down}`, '-7 -2 to -3 2'],
  ['a mirrored polyline', `0 LWPOLYLINE 8 0 90 2 70 0 10 0 20 0 10 10 20 5 ${down}`, '-10 0 to 0 5'],
  ['a block', '0 INSERT 8 0 2 PART 10 20 20 30 30 0', '20 30 to 30 35'],
  ['an array of blocks', '0 INSERT 8 0 2 PART 10 20 20 30 30 0 70 2 44 100', '20 30 to 130 35'],
  ['a layer that is off', '0 LINE 8 OFF 10 0 20 0 30 0 11 10 21 5 31 0', 'nothing'],
  ['a frozen layer', '0 LINE 8 FROZEN 10 0 20 0 30 0 11 10 21 5 31 0', 'nothing'],
  ['paper space', '0 LINE 8 0 67 1 10 0 20 0 30 0 11 10 21 5 31 0', 'nothing']]) {
  const loader = new DXFLoader();
  loader.setEnableLayer(true);
  loader.setDefaultColor(0);
  const scene = loader.parse(drawing(entities))?.entity;
  scene?.updateMatrixWorld(true);
  const box = new Box3().setFromObject(scene), text = ({ x, y }) => `${Math.round(x)} ${Math.round(y)}`;
  console.log(`${name}: ${text(box.min)} to ${text(box.max)}, right would be ${right}`.replace(/: (.*), right would be \1$/, ': $1'));
}
JS
node read.mjs >seen 2>messages
expect_in seen <<'END'
a circle: 3 -2 to 7 2
a circle without z: NaN NaN to NaN NaN, right would be 3 -2 to 7 2
a mirrored circle: 3 -2 to 7 2, right would be -7 -2 to -3 2
a mirrored polyline: 0 0 to 10 5, right would be -10 0 to 0 5
a block: 23 34 to 33 39, right would be 20 30 to 30 35
an array of blocks: 23 34 to 33 39, right would be 20 30 to 130 35
a layer that is off: 0 0 to 10 5, right would be nothing
a frozen layer: 0 0 to 10 5, right would be nothing
paper space: 0 0 to 10 5, right would be nothing
END
