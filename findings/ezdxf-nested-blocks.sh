#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A line of 10 in a block, turned by 90 degrees in a second block, which stands in the drawing at x scale 2, y scale 1: an upright line
# of 10. Believed: everyone has 10. ezdxf 0.18.1 makes it 20 long when it takes blocks apart (virtual_entities, on
# which its bounding boxes and its drawing add-on stand), as though the scale came before the turn. GDAL 3.6.2 and npm's dxf have 10.
. "$(dirname "$(realpath "$0")")/packages.sh"
npm_packages dxf@5.3.1
debian_packages gdal-bin=3.6.2+dfsg-1+b2 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages
export PROJ_DATA=$work/root/usr/share/proj GDAL_DATA=$work/root/usr/share/gdal
cat >blocks.py <<'PY'
import ezdxf
from ezdxf import bbox

drawing = ezdxf.new("R2000")
drawing.blocks.new("INNER").add_line((0, 0), (10, 0))
drawing.blocks.new("OUTER").add_blockref("INNER", (0, 0), dxfattribs={"rotation": 90})
outer = drawing.modelspace().add_blockref("OUTER", (0, 0), dxfattribs={"xscale": 2, "yscale": 1})
drawing.saveas("blocks.dxf")
[inner] = outer.virtual_entities()
[line] = inner.virtual_entities()
print(f"ezdxf scales of the inner block: x {inner.dxf.xscale:g}, y {inner.dxf.yscale:g}; turned by {inner.dxf.rotation:g}")
print(f"ezdxf line: {(line.dxf.end - line.dxf.start).magnitude:.1f} long")
print(f"ezdxf box: {bbox.extents(drawing.modelspace()).size.y:.1f} high")
PY
cat >npm.cjs <<'JS'
const { Helper } = require('dxf');
const [line] = new Helper(require('fs').readFileSync('blocks.dxf', 'utf8')).toPolylines().polylines;
const [[x, y], [u, v]] = line.vertices;
console.log(`npm dxf line: ${Math.hypot(u - x, v - y).toFixed(1)} long`);
JS
{
  python3 blocks.py
  node npm.cjs
  ogr2ogr -f GeoJSON /vsistdout/ blocks.dxf | python3 -c 'import json, math, sys
print(f"""GDAL line: {math.dist(*json.load(sys.stdin)["features"][0]["geometry"]["coordinates"]):.1f} long""")'
} >seen
expect_in seen <<'END'
ezdxf scales of the inner block: x 2, y 1; turned by 90
ezdxf line: 20.0 long
ezdxf box: 20.0 high
npm dxf line: 10.0 long
GDAL line: 10.0 long
END
