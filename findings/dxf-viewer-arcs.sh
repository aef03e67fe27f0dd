#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# npm's dxf-viewer 1.0.49 draws arcs of DXF below 20 degrees as their chord, whatever minArcTessellationSubdivisions, which is 8, says: one of 15 degrees
# and a radius of 1 m is 8.6 mm off. It draws one of an array of blocks, splines without their weights, arcs of polylines on a mirrored plane
# (extrusion direction down) on the other side, and what is on paper space, and leaves leaders out. Nothing is said. Longer arcs have a chord for
# each 10 degrees, as its options say; mirrored circles, blocks and ellipses are right. Believed: what AutoCAD's reference gives.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf-viewer@1.0.49
cat >draw.mjs <<'JS'
import DxfParser from './node_modules/dxf-viewer/src/parser/DxfParser.js';
import { DxfScene } from './node_modules/dxf-viewer/src/DxfScene.js';
import { SceneReader } from './node_modules/dxf-viewer/src/SceneReader.js';
const said = console.log;
console.log = () => {};
const drawn = async (entities) => {
  const text = `0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 PART 70 0 10 0 20 0 30 0 3 PART
    0 LINE 8 0 10 0 20 0 30 0 11 10 21 5 31 0 0 ENDBLK 8 0 0 ENDSEC 0 SECTION 2 ENTITIES ${entities} 0 ENDSEC 0 EOF`.trim().split(/\s+/).join('\n') + '\n';
  const scene = new DxfScene({});
  await scene.Build(new DxfParser().parseSync(text), []);
  return [...new SceneReader(scene.scene).ReadPrimitives()].map((it) => it.vertices);
};
for (const to of [15, 30, 90]) {
  const points = (await drawn(`0 ARC 8 0 10 0 20 0 30 0 40 1000 50 0 51 ${to}`))[0];
  const sag = Math.max(...points.slice(1).map(([x, y], i) => 1000 - Math.hypot(x + points[i][0], y + points[i][1]) / 2));
  said(`an arc of ${to} degrees, radius 1000: ${points.length - 1} chords, ${sag.toFixed(1)} off`);
}
const weight = Math.SQRT1_2, down = '210 0 220 0 230 -1';
for (const [name, entities, right] of [
  ['three blocks in a row', '0 INSERT 8 0 2 PART 10 20 20 30 30 0 41 1 42 1 43 1 70 3 44 50', '20 30 to 130 35'],
  ['a mirrored block', `0 INSERT 8 0 2 PART 10 20 20 30 30 0 ${down}`, '-30 30 to -20 35'],
  ['a mirrored half circle as polyline', `0 LWPOLYLINE 8 0 90 2 70 0 ${down} 10 0 20 0 42 1 10 40 20 0`, '-40 -20 to 0 0'],
  ['an arc as rational spline', `0 SPLINE 8 0 70 12 71 2 72 6 73 3 74 0 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 ${weight} 41 1
    10 14.1421356 20 14.1421356 30 0 10 0 20 28.2842712 30 0 10 -14.1421356 20 14.1421356 30 0`, '-14 14 to 14 20'],
  ['a leader', '0 LEADER 8 0 71 0 76 2 10 0 20 0 30 0 10 10 20 10 30 0', '0 0 to 10 10'],
  ['paper space', '0 LINE 8 0 67 1 10 0 20 0 30 0 11 10 21 5 31 0', 'nothing']]) {
  const points = (await drawn(entities)).flat(), limit = (of, axis) => Math.round(of(...points.map((point) => point[axis]))) + 0;
  const box = points.length ? `${limit(Math.min, 0)} ${limit(Math.min, 1)} to ${limit(Math.max, 0)} ${limit(Math.max, 1)}` : 'nothing';
  said(`${name}: ${box}${box === right ? '' : `, right would be ${right}`}`);
}
JS
node draw.mjs >seen 2>messages
expect_in seen <<'END'
an arc of 15 degrees, radius 1000: 1 chords, 8.6 off
an arc of 30 degrees, radius 1000: 3 chords, 3.8 off
an arc of 90 degrees, radius 1000: 9 chords, 3.8 off
three blocks in a row: 20 30 to 30 35, right would be 20 30 to 130 35
a mirrored block: -30 30 to -20 35
a mirrored half circle as polyline: -40 0 to 0 20, right would be -40 -20 to 0 0
an arc as rational spline: -14 14 to 14 21, right would be -14 14 to 14 20
a leader: nothing, right would be 0 0 to 10 10
paper space: 0 0 to 10 5, right would be nothing
END
