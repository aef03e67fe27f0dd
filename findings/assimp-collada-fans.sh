#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# assimp 5.2.5 takes each trifans of a COLLADA for one polygon through all its points: a cone 10 high becomes a face of ten corners in OBJ, and in
# STL a flat disc. Triangles and flat fans are right. Nothing is said. Believed: each two points that follow each other make
# a triangle with the first (COLLADA 1.4.1, trifans).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1
cat >write.py <<'PY'
import math
ring = [(10 * math.cos(i * math.pi / 4), 10 * math.sin(i * math.pi / 4), 0) for i in range(8)]
around = [*range(1, 9), 1]

def write(name, tip, what, indices):
    numbers = " ".join(f"{value:.6f}" for point in [tip, *ring] for value in point)
    with open(name + ".dae", "w") as file:
        file.write(f"""<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><created>2020-01-01T00:00:00Z</created><modified>2020-01-01T00:00:00Z</modified><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="27">{numbers}</float_array>
<technique_common><accessor source="#a" count="9" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
{what}<input semantic="VERTEX" source="#v" offset="0"/><p>{" ".join(map(str, indices))}</p></{what[1:].split()[0]}></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>""")

facets = [index for i in range(8) for index in (0, around[i], around[i + 1])]
for kind, tip in (("disc", (0, 0, 0)), ("cone", (0, 0, 10))):
    write(kind + " of triangles", tip, '<triangles count="8">', facets)
    write(kind + " of a fan", tip, '<trifans count="1">', [0, *around])
PY
cat >area.py <<'PY'
import math, re, sys
corners = [tuple(map(float, match)) for match in re.findall(r"vertex\s+(\S+)\s+(\S+)\s+(\S+)", open("mesh.stl").read())]
area = volume = 0
for p, q, r in zip(corners[::3], corners[1::3], corners[2::3]):
    u, v = ([b[k] - p[k] for k in range(3)] for b in (q, r))
    cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    area += math.hypot(*cross) / 2
    volume += sum(p[k] * cross[k] for k in range(3)) / 6
faces = [len(line.split()) - 1 for line in open("mesh.obj") if line.startswith("f ")]
print(f"{sys.argv[1]}: {len(faces)} faces of up to {max(faces)} corners in OBJ; area {area:.1f}, volume above z = 0 {volume:.1f} in STL")
PY
python3 write.py
for name in *.dae; do
  for format in obj stl; do assimp export "$name" "mesh.$format" >messages 2>&1 || { cat messages >&2; exit 1; }; done
  python3 area.py "${name%.dae}"
done >seen
expect_in seen <<'END'
cone of a fan: 1 faces of up to 10 corners in OBJ; area 282.8, volume above z = 0 0.0 in STL
cone of triangles: 8 faces of up to 3 corners in OBJ; area 416.8, volume above z = 0 942.8 in STL
disc of a fan: 1 faces of up to 10 corners in OBJ; area 282.8, volume above z = 0 0.0 in STL
disc of triangles: 8 faces of up to 3 corners in OBJ; area 282.8, volume above z = 0 0.0 in STL
END
