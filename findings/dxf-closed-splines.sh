#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A closed uniform cubic SPLINE of DXF, whose knots repeat nowhere, round a square of 10: it lies at 0.42..9.58 and is 29.2 long. GDAL
# 3.6.2 begins and ends it in the first and last control point (46.5 long); ezdxf 0.18.1 reads it right, but its paths, and so its
# drawing add-on, run 112 away. Believed: 29.2 everywhere, as npm's dxf 5.3.1 has it.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf@5.3.1
debian_packages gdal-bin=3.6.2+dfsg-1+b2 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
export PROJ_DATA=$work/root/usr/share/proj GDAL_DATA=$work/root/usr/share/gdal
cat >write.py <<'PY'
import json
import ezdxf
from ezdxf import path

square = [(0, 0), (10, 0), (10, 10), (0, 10)]
drawing = ezdxf.new("R2000")
spline = drawing.modelspace().add_spline(degree=3)
spline.set_uniform(square + square[:3], degree=3)
drawing.saveas("spline.dxf")
for name, points in (("entity", spline.flattening(0.001)), ("path", path.make_path(spline).flattening(0.001))):
    json.dump([(p.x, p.y) for p in points], open(f"ezdxf-{name}.json", "w"))
PY
cat >npm.cjs <<'JS'
const fs = require('fs');
const { Helper } = require('dxf');
const [line] = new Helper(fs.readFileSync('spline.dxf', 'utf8')).toPolylines().polylines;
fs.writeFileSync('npm-dxf.json', JSON.stringify(line.vertices));
JS
python3 write.py
node npm.cjs
ogr2ogr -f GeoJSON /vsistdout/ spline.dxf | python3 -c 'import json, sys
print(json.dumps(json.load(sys.stdin)["features"][0]["geometry"]["coordinates"]))' >gdal.json
for name in npm-dxf ezdxf-entity ezdxf-path gdal; do
  python3 - "$name" <<'PY'
import json, math, sys
points = json.load(open(sys.argv[1] + ".json"))
length = sum(math.dist(a, b) for a, b in zip(points, points[1:]))
print(f"{sys.argv[1]}: x {min(p[0] for p in points):.1f} to {max(p[0] for p in points):.1f}, {length:.0f} long")
PY
done >seen
expect_in seen <<'END'
npm-dxf: x 0.4 to 9.6, 29 long
ezdxf-entity: x 0.4 to 9.6, 29 long
ezdxf-path: x -111.7 to 9.6, 194 long
gdal: x 0.0 to 10.0, 47 long
END
