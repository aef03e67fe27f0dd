#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The extrusion direction (0, 0, -1), which CAD programs write for what was mirrored: npm's dxf 5.3.1 mirrors an ELLIPSE, whose centre
# and axis stand in world coordinates and must not be mirrored, and leaves an LWPOLYLINE, which must be, unmirrored; an ARC is right.
# Believed: all as ezdxf and GDAL have them.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf@5.3.1
debian_packages gdal-bin=3.6.2+dfsg-1+b2 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
export PROJ_DATA=$work/root/usr/share/proj GDAL_DATA=$work/root/usr/share/gdal
cat >write.py <<'PY'
import json, subprocess
import ezdxf
from ezdxf import path

down = {"extrusion": (0, 0, -1)}
for name in ("arc", "ellipse", "polyline"):
    drawing = ezdxf.new("R2000")
    space = drawing.modelspace()
    entity = {"arc": lambda: space.add_arc((30, 0), 10, 0, 90, dxfattribs=down),
              "ellipse": lambda: space.add_ellipse((30, 0), (10, 0), 0.5, 0, 3.14159265, dxfattribs=down),
              "polyline": lambda: space.add_lwpolyline([(30, 0), (40, 5)], dxfattribs=down)}[name]()
    drawing.saveas(name + ".dxf")
    subprocess.run(["ogr2ogr", "-f", "GeoJSON", "/vsistdout/", name + ".dxf"], stdout=open("gdal.json", "wb"), check=True)
    lines = {"ezdxf": [(p.x, p.y) for p in path.make_path(entity).flattening(0.001)],
             "GDAL": json.load(open("gdal.json"))["features"][0]["geometry"]["coordinates"],
             "npm dxf": json.loads(subprocess.run(["node", "npm.cjs", name + ".dxf"], capture_output=True, check=True).stdout)}
    for reader, points in lines.items():
        box = [round(limit(p[i] for p in points)) + 0 for i in (0, 1) for limit in (min, max)]
        print("%s, %s: x %d to %d, y %d to %d" % (name, reader, *box))
PY
cat >npm.cjs <<'JS'
const { Helper } = require('dxf');
const [line] = new Helper(require('fs').readFileSync(process.argv[2], 'utf8')).toPolylines().polylines;
console.log(JSON.stringify(line.vertices));
JS
python3 write.py >seen
expect_in seen <<'END'
arc, ezdxf: x -40 to -30, y 0 to 10
arc, GDAL: x -40 to -30, y 0 to 10
arc, npm dxf: x -40 to -30, y 0 to 10
ellipse, ezdxf: x 20 to 40, y -5 to 0
ellipse, GDAL: x 20 to 40, y -5 to 0
ellipse, npm dxf: x -40 to -20, y 0 to 5
polyline, ezdxf: x -40 to -30, y 0 to 5
polyline, GDAL: x -40 to -30, y 0 to 5
polyline, npm dxf: x 30 to 40, y 0 to 5
END
