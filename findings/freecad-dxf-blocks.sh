#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2 reads blocks of DXF (Import.readDXF, its usual reader) elsewhere and in other sizes: uneven scales become their geometric
# mean in all directions, so that x = y = 2, z = 1 draws a line of 10 at 15.9; it is placed by the origin, not by the base point; of an
# array of 3 x 2 one copy is read. A quarter of an ellipse becomes a whole one. GDAL 3.6.2 has all right.
# Believed: lengths in the plane are kept whatever the scale of z.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1 gdal-bin=3.6.2+dfsg-1+b2 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
export PROJ_DATA=$work/root/usr/share/proj GDAL_DATA=$work/root/usr/share/gdal
cat >write.py <<'PY'
import ezdxf

inserts = {"plain": {}, "x = y = 2, z = 1": {"xscale": 2, "yscale": 2}, "x = 2, y = z = 1": {"xscale": 2},
           "array": {"column_count": 3, "row_count": 2, "column_spacing": 20, "row_spacing": 20}}
for name in (*inserts, "quarter ellipse"):
    drawing = ezdxf.new("R2000")
    drawing.header["$INSUNITS"] = 4
    space = drawing.modelspace()
    drawing.blocks.new("LINE", base_point=(5, 0)).add_line((5, 0), (15, 0))
    if name == "quarter ellipse":
        space.add_ellipse((100, 0), (10, 0), 0.5, 0, 1.5707963)
    else:
        space.add_blockref("LINE", (100, 0), dxfattribs=inserts[name])
    drawing.saveas(name + ".dxf")
PY
cat >read.py <<'PY'
import FreeCAD, Import, Part
import json, math, subprocess

for name in ("plain", "x = y = 2, z = 1", "x = 2, y = z = 1", "array", "quarter ellipse"):
    document = FreeCAD.newDocument("d")
    Import.readDXF(name + ".dxf", "d")
    edges = [edge for thing in document.Objects if hasattr(thing, "Shape") for edge in thing.Shape.Edges]
    begin = min((vertex.X for edge in edges for vertex in edge.Vertexes), default=math.nan)
    FreeCAD.closeDocument("d")
    subprocess.run(["ogr2ogr", "-f", "GeoJSON", "/vsistdout/", name + ".dxf"], stdout=open("gdal.json", "wb"), check=True)
    lines = []
    for feature in json.load(open("gdal.json"))["features"]:
        shape = feature["geometry"]
        lines += [shape["coordinates"]] if shape["type"] == "LineString" else shape["coordinates"]
    length = sum(math.dist(a, b) for line in lines for a, b in zip(line, line[1:]))
    print(f"{name}: GDAL {length:.1f} long from x = {min(p[0] for line in lines for p in line):.0f}, "
          f"FreeCAD {sum(edge.Length for edge in edges):.1f} from {begin:.0f}")
PY
python3 write.py
python3 read.py >seen
expect_in seen <<'END'
plain: GDAL 10.0 long from x = 100, FreeCAD 10.0 from 105
x = y = 2, z = 1: GDAL 20.0 long from x = 100, FreeCAD 15.9 from 108
x = 2, y = z = 1: GDAL 20.0 long from x = 100, FreeCAD 12.6 from 106
array: GDAL 60.0 long from x = 100, FreeCAD 10.0 from 105
quarter ellipse: GDAL 12.1 long from x = 100, FreeCAD 48.4 from 110
END
