#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A polyline of DXF to which a spline was fitted has the frame of the spline as corners with the flag 16 (group 70 of VERTEX), which are not drawn, before
# those of the curve. npm's dxf 5.3.1, three-dxf-loader 5.2.0 and SpatiaLite 5.0.1 (spatialite_dxf) make one line of both: a curve of 40 x 30 mm
# is 40 high, 240 long instead of 80, with a line across its ends. Nothing is said. dime is right. Believed: the curve alone.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf@5.3.1 three-dxf-loader@5.2.0 three@0.160.0
debian_packages spatialite-bin=5.0.1-2 dime=0.20111205-2.1
cat >draw.mjs <<'JS'
import { readFileSync, writeFileSync } from 'fs';
import { createRequire } from 'module';
const { Helper } = createRequire(import.meta.url)('dxf');
import { DXFLoader } from 'three-dxf-loader';
const frame = [[0, 0], [0, 40], [40, 40], [40, 0]], curve = Array.from({ length: 9 }, (_, i) => i / 8).map((t) => [0, 1].map((axis) =>
  [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3].reduce((sum, weight, i) => sum + weight * frame[i][axis], 0)));
const corners = [...frame.map((corner) => [...corner, 16]), ...curve.map((corner) => [...corner, 8])];
writeFileSync('curve.dxf', `0 SECTION 2 HEADER 9 $ACADVER 1 AC1009 0 ENDSEC 0 SECTION 2 ENTITIES 0 POLYLINE 8 0 66 1 10 0 20 0 30 0 70 4 75 6
  ${corners.map(([x, y, flag]) => `0 VERTEX 8 0 10 ${x} 20 ${y} 30 0 70 ${flag}`).join(' ')} 0 SEQEND 8 0 0 ENDSEC 0 EOF`.split(/\s+/).join('\n') + '\n');
const text = readFileSync('curve.dxf', 'utf8');
const said = (name, points) => console.log(`${name}: ${points.length} corners, ${Math.max(...points.map(([, y]) => y))} high, ` +
  `${points.slice(1).reduce((sum, [x, y], i) => sum + Math.hypot(x - points[i][0], y - points[i][1]), 0).toFixed(0)} long`);
said('right would be', curve);
said('dxf', new Helper(text).toPolylines().polylines[0].vertices);
const loader = new DXFLoader();
loader.setDefaultColor(0);
const places = loader.parse(text).entity.children[0].geometry.attributes.position;
said('three-dxf-loader', Array.from({ length: places.count }, (_, i) => [places.getX(i), places.getY(i)]));
JS
node draw.mjs >seen 2>messages
spatialite_dxf -d curve.sqlite -x curve.dxf -mixed >messages 2>&1
echo "spatialite_dxf: $(spatialite curve.sqlite 'select NumPoints(geometry), MbrMaxY(geometry), round(GLength(geometry)) from line_layer_2d' 2>/dev/null)" >>seen
dxf2vrml curve.dxf >curve.wrl
echo "dime: $(python3 -c '
import re
points = re.search(r"point \[([^]]*)\]", open("curve.wrl").read())[1].split(",")
print(len(points), "corners,", max(float(point.split()[1]) for point in points), "high")')" >>seen
expect_in seen <<'END'
right would be: 9 corners, 30 high, 80 long
dxf: 13 corners, 40 high, 240 long
three-dxf-loader: 13 corners, 40 high, 240 long
spatialite_dxf: 13|40.0|240.0
dime: 9 corners, 30.0 high
END
