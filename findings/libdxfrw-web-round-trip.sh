#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# npm's @mlightcad/libdxfrw-web 0.1.0 (libdxfrw, which LibreCAD uses, for browsers) writes a DXF that it read otherwise: without the planes of circles, arcs,
# polylines, ellipses and blocks, so that what was mirrored (extrusion direction down) lies elsewhere; hatches along polylines without their outline,
# 3DFACEs and the points of splines through points not at all, the flags of vertices replaced by those of the polyline, so that frames of splines
# become visible and meshes broken, and the invisible visible. Reading succeeds. Bulges, weights of splines and arrays of blocks
# are kept. Believed: what can be read and is to be written is kept.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @mlightcad/libdxfrw-web@0.1.0
cat >convert.cjs <<'JS'
const down = '210 0 220 0 230 -1';
require('@mlightcad/libdxfrw-web/dist/libdxfrw.js')().then((library) => {
  for (const [name, entity, kept] of [
    ['a mirrored circle', `0 CIRCLE 8 0 10 50 20 0 30 0 40 10 ${down}`, ['230 -1']],
    ['a mirrored ellipse', `0 ELLIPSE 8 0 10 50 20 0 30 0 11 10 21 0 31 0 ${down} 40 0.5 41 0 42 1.5`, ['230 -1']],
    ['a mirrored polyline', `0 LWPOLYLINE 8 0 90 2 70 0 ${down} 10 0 20 0 42 1 10 10 20 0`, ['42 1', '230 -1']],
    ['a mirrored array of blocks', `0 INSERT 8 0 2 PART 10 20 20 30 30 0 70 3 44 50 ${down}`, ['70 3', '230 -1']],
    ['a hatch', '0 HATCH 8 0 10 0 20 0 30 0 2 SOLID 70 1 71 0 91 1 92 2 72 0 73 1 93 3 10 0 20 0 10 40 20 0 10 40 20 30 97 0 75 0 76 1 98 0', ['93 3', '10 40', '20 30']],
    ['a spline with weights', '0 SPLINE 8 0 70 12 71 2 72 6 73 3 74 0 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 0.5 41 1 10 20 20 0 30 0 10 20 20 20 30 0 10 0 20 20 30 0', ['41 0.5']],
    ['a spline through points', '0 SPLINE 8 0 70 8 71 3 72 0 73 0 74 3 11 0 21 0 31 0 11 20 21 20 31 0 11 40 21 0 31 0', ['11 20', '21 20']],
    ['a 3DFACE', '0 3DFACE 8 0 10 0 20 0 30 0 11 10 21 0 31 0 12 10 22 5 32 0 13 0 23 5 33 0', ['0 3DFACE']],
    ['the frame of a spline', '0 POLYLINE 8 0 66 1 70 4 10 0 20 0 30 0 0 VERTEX 8 0 10 0 20 0 30 0 70 16 0 VERTEX 8 0 10 5 20 5 30 0 70 8 0 SEQEND 8 0', ['70 16', '70 8']],
    ['an invisible line', '0 LINE 8 0 60 1 10 0 20 0 30 0 11 10 21 5 31 0', ['60 1']]]) {
    const text = `0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 0 ENDSEC 0 SECTION 2 BLOCKS 0 BLOCK 8 0 2 PART 70 0 10 0 20 0 30 0 3 PART
      0 LINE 8 0 10 0 20 0 30 0 11 10 21 5 31 0 0 ENDBLK 8 0 0 ENDSEC 0 SECTION 2 ENTITIES ${entity} 0 ENDSEC 0 EOF`.trim().split(/\s+/).join('\n') + '\n';
    const database = new library.DRW_Database(), handler = new library.DRW_FileHandler();
    handler.database = database;
    const read = new library.DRW_DxfRW(text).read(handler, false);
    const written = handler.fileExport(library.DRW_Version.AC1015, false, database, false).split(/\r?\n/).map((line) => line.trim());
    const entities = written.slice(written.indexOf('ENTITIES') + 1), end = entities.indexOf('ENDSEC');
    const groups = new Set(Array.from({ length: end / 2 }, (_, i) => `${entities[2 * i]} ${entities[2 * i + 1]}`));
    console.log(`${name}: read ${read}, ${kept.map((group) => `${group} ${groups.has(group) ? 'kept' : 'lost'}`).join(', ')}`);
  }
});
JS
node convert.cjs >seen
expect_in seen <<'END'
a mirrored circle: read true, 230 -1 lost
a mirrored ellipse: read true, 230 -1 lost
a mirrored polyline: read true, 42 1 kept, 230 -1 lost
a mirrored array of blocks: read true, 70 3 kept, 230 -1 lost
a hatch: read true, 93 3 lost, 10 40 lost, 20 30 lost
a spline with weights: read true, 41 0.5 kept
a spline through points: read true, 11 20 lost, 21 20 lost
a 3DFACE: read true, 0 3DFACE lost
the frame of a spline: read true, 70 16 lost, 70 8 lost
an invisible line: read true, 60 1 lost
END
