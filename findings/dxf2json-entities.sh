#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# npm's dxf2json 1.0.3 (parseContent) reads a DXF whose lines end as on Unix, as ezdxf and others write them there, as an empty drawing; its
# init(path) reads the same file. After an insert that says that no attributes follow (66 = 0, the default), neither reads anything more.
# toGeojson makes features of ellipses that have no type. Nothing is said. Believed: five entities each time.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf2json@1.0.3
cat >read.cjs <<'JS'
const { readFileSync, writeFileSync } = require('fs'), { DxfParser, toGeojson } = require('dxf2json');
const plain = [[0, 'LINE'], [8, 0], [10, 0], [20, 0], [11, 10], [21, 5]];
const drawing = (flag) => [[0, 'SECTION'], [2, 'HEADER'], [9, '$ACADVER'], [1, 'AC1015'], [0, 'ENDSEC'],
  [0, 'SECTION'], [2, 'BLOCKS'], [0, 'BLOCK'], [8, 0], [2, 'PART'], [70, 0], [10, 0], [20, 0], ...plain, [0, 'ENDBLK'], [0, 'ENDSEC'],
  [0, 'SECTION'], [2, 'ENTITIES'], ...plain, [0, 'INSERT'], [8, 0], ...flag, [2, 'PART'], [10, 20], [20, 0], ...plain,
  [0, 'CIRCLE'], [8, 0], [10, 0], [20, 0], [40, 10],
  [0, 'ELLIPSE'], [8, 0], [10, 0], [20, 0], [11, 10], [21, 0], [40, 0.5], [41, 0], [42, 3], [0, 'ENDSEC'], [0, 'EOF']].flat();
(async () => {
  for (const [name, flag, end] of [['lines end by CR LF', [], '\r\n'], ['by LF', [], '\n'], ['CR LF, no attributes follow', [[66, 0]], '\r\n']]) {
    writeFileSync('drawing.dxf', drawing(flag).join(end) + end);
    const text = await new DxfParser().parseContent(readFileSync('drawing.dxf', 'utf8')), file = await new DxfParser().init('drawing.dxf');
    const types = ({ ENTITIES }) => ENTITIES.map((it) => it.type).join(' ') || 'nothing';
    console.log(`${name}: parseContent ${types(text)}; init ${types(file)}; types of GeoJSON ${toGeojson(file).features.map((it) => it.geometry.type).join(' ')}`);
  }
})();
JS
node read.cjs >seen
expect_in seen <<'END'
lines end by CR LF: parseContent LINE INSERT LINE CIRCLE ELLIPSE; init LINE INSERT LINE CIRCLE ELLIPSE; types of GeoJSON LineString Point LineString Point 
by LF: parseContent nothing; init LINE INSERT LINE CIRCLE ELLIPSE; types of GeoJSON LineString Point LineString Point 
CR LF, no attributes follow: parseContent LINE INSERT; init LINE INSERT; types of GeoJSON LineString Point
END
