#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Dia 0.97.3 (Debian's 20220525) reads of a DXF in millimetres a line of 100 as 100 cm, leaves LWPOLYLINE and SPLINE out, draws what
# stands in a block once, at the origin and not where it is inserted, makes hidden lines solid, and an ellipse 40 x 20 one of 0.5 x 10
# elsewhere. It ends with success. Believed: what it cannot read is named; GDAL 3.6.2 reads all
# of it.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages dia=0.97.3+git20220525-5 gdal-bin=3.6.2+dfsg-1+b2 python3-ezdxf=0.18.1-1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages HOME=$work
export PROJ_DATA=$work/root/usr/share/proj GDAL_DATA=$work/root/usr/share/gdal
export DIA_LIB_PATH=$work/root/usr/lib/x86_64-linux-gnu/dia DIA_BASE_PATH=$work/root/usr/share/dia
export LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$DIA_LIB_PATH
cat >write.py <<'PY'
import ezdxf

def block(drawing, space):
    drawing.blocks.new("B").add_line((0, 0), (10, 0))
    for x in (100, 200):
        space.add_blockref("B", (x, 50))

contents = {"line": lambda drawing, space: space.add_line((0, 0), (100, 0)),
            "hidden line": lambda drawing, space: space.add_line((0, 0), (100, 0), dxfattribs={"linetype": "HIDDEN"}),
            "polyline": lambda drawing, space: space.add_lwpolyline([(0, 0), (100, 0), (100, 50)]),
            "spline": lambda drawing, space: space.add_open_spline([(0, 0), (50, 20), (100, 0), (150, 20)]),
            "two blocks": block,
            "ellipse": lambda drawing, space: space.add_ellipse((50, 50), (20, 0), 0.5)}
for name, fill in contents.items():
    drawing = ezdxf.new("R2000")
    drawing.header["$INSUNITS"] = 4
    drawing.linetypes.add("HIDDEN", [9, 6, -3])
    fill(drawing, drawing.modelspace())
    drawing.saveas(name + ".dxf")
PY
cat >places.py <<'PY'
import json, re, sys
name = sys.argv[1]

def box(points):
    if not points:
        return "nothing"
    return ", ".join("%s %g to %g" % (axis, *(round(limit(p[i] for p in points), 1) + 0 for limit in (min, max))) for i, axis in enumerate("xy"))

def flat(thing):
    return [thing[:2]] if isinstance(thing[0], (int, float)) else [point for part in thing for point in flat(part)]

shapes = [feature["geometry"] for feature in json.load(open("gdal.json"))["features"]]
shapes = [part for shape in shapes for part in shape.get("geometries", [shape])]
print(f"{name}: GDAL {box([point for shape in shapes for point in flat(shape['coordinates'])])}")
text = open("dia.svg").read()
unit = 20  # user units of its SVG in each cm of the diagram
points = []
for kind, attributes in re.findall(r"<(line|ellipse|poly\w+|path|circle|rect) ([^>]*)>", text):
    value = {key: number for key, number in re.findall(r' (\w+)="([^"]*)"', " " + attributes)}
    if kind == "line":
        points += [(float(value["x1"]), -float(value["y1"])), (float(value["x2"]), -float(value["y2"]))]
    elif kind == "ellipse":
        points += [(float(value["cx"]) + s * float(value["rx"]), -float(value["cy"]) + s * float(value["ry"])) for s in (-1, 1)]
    else:
        sys.exit("unexpected " + kind)
print(f"{name}: Dia, in cm, {box([(x / unit, y / unit) for x, y in points])}" + (", dashed" if "dasharray" in text else ""))
PY
python3 write.py
for name in line 'hidden line' polyline spline 'two blocks' ellipse; do
  rm -f gdal.json
  ogr2ogr -f GeoJSON gdal.json "$name.dxf"
  dia -e dia.svg "$name.dxf" >messages 2>&1 || { cat messages >&2; exit 1; }
  python3 places.py "$name"
done >seen
expect_in seen <<'END'
line: GDAL x 0 to 100, y 0 to 0
line: Dia, in cm, x 0 to 100, y 0 to 0
hidden line: GDAL x 0 to 100, y 0 to 0
hidden line: Dia, in cm, x 0 to 100, y 0 to 0
polyline: GDAL x 0 to 100, y 0 to 50
polyline: Dia, in cm, nothing
spline: GDAL x 0 to 150, y 0 to 20
spline: Dia, in cm, nothing
two blocks: GDAL x 100 to 210, y 50 to 50
two blocks: Dia, in cm, x 0 to 10, y 0 to 0
ellipse: GDAL x 30 to 70, y 40 to 60
ellipse: Dia, in cm, x 49.5 to 50, y 50 to 60
END
