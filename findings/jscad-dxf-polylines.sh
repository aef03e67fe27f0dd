#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# @jscad/dxf-deserializer 2.3.30: each POLYLINE of a DXF, as R12 and laser cutters have them, begins with all corners of those before it, and closed
# ones come open: three squares become one of 4, one of 8 and one of 12 corners, joined by lines that nobody drew. Its own
# @jscad/dxf-serializer 2.1.23 writes them if asked (geom2To "polyline"). LWPOLYLINE is right. Nothing is said. Believed: four corners each,
# closed (DXF reference, POLYLINE, group 70, and SEQEND).
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages @jscad/dxf-deserializer@2.3.30 @jscad/dxf-serializer@2.1.23 @jscad/modeling@2.13.0
debian_packages python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
cat >draw.py <<'PY'
import ezdxf

for version, add in (("R12", "add_polyline2d"), ("R2000", "add_lwpolyline")):
    drawing = ezdxf.new(version)
    for x in (0, 30, 60):
        getattr(drawing.modelspace(), add)([(x, 0), (x + 10, 0), (x + 10, 10), (x, 10)], close=True)
    drawing.saveas(version + ".dxf")
PY
cat >read.cjs <<'JS'
const { deserialize } = require('@jscad/dxf-deserializer');
const { serialize } = require('@jscad/dxf-serializer');
const { booleans: { union }, geometries: { path2 }, measurements: { measureBoundingBox }, primitives: { rectangle }, transforms: { translate } } = require('@jscad/modeling');
const { readFileSync } = require('fs');
const told = (name, text) => console.log(`${name}: ` + [].concat(deserialize({ output: 'geometry' }, text)).flat(Infinity).map((path) => {
  const [low, high] = measureBoundingBox(path);
  return `${path2.toPoints(path).length} corners, ${path.isClosed ? 'closed' : 'open'}, x ${Math.round(low[0])} to ${Math.round(high[0])}`;
}).join('; '));
for (const version of ['R12', 'R2000']) told(version, readFileSync(`${version}.dxf`, 'utf8'));
const square = (x) => rectangle({ size: [10, 10], center: [x + 5, 5] });
told('JSCAD', serialize({ geom2To: 'polyline' }, union(square(0), square(30))).join(''));
JS
python3 draw.py
node read.cjs >seen
expect_in seen <<'END'
R12: 4 corners, open, x 0 to 10; 8 corners, open, x 0 to 40; 12 corners, open, x 0 to 70
R2000: 4 corners, closed, x 0 to 10; 4 corners, closed, x 30 to 40; 4 corners, closed, x 60 to 70
JSCAD: 4 corners, closed, x 0 to 10; 10 corners, open, x 0 to 40
END
