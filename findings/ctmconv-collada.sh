#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenCTM 1.0.3 (ctmconv) reads of a COLLADA its meshes and not its scene: parts of an assembly lie at the origin, one of several copies, unturned,
# unscaled, whatever the file's unit and upper axis are. Of faces with four corners it reads none, and writes an empty file. It says nothing, and
# ends with success. What it writes itself names neither unit nor axis, which are then metres and y (COLLADA 1.4.1, asset), and has
# six digits: an edge of 10.4 mm at 123 m becomes 11. Believed: boxes where COLLADA's nodes place them, and the size that was given.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages openctm-tools=1.0.3+dfsg1-2.1+b3
cat >assembly.py <<'PY'
import sys
corners = " ".join(f"{10 * (i & 1)} {10 * (i >> 1 & 1)} {10 * (i >> 2)}" for i in range(8))
triangles = "0 2 3 0 3 1 4 5 7 4 7 6 0 1 5 0 5 4 2 6 7 2 7 3 0 4 6 0 6 2 1 3 7 1 7 5"
quads = "0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5"
faces = {"triangles": f'<triangles count="12"><input semantic="VERTEX" source="#v" offset="0"/><p>{triangles}</p></triangles>',
         "quads": f'<polylist count="6"><input semantic="VERTEX" source="#v" offset="0"/><vcount>4 4 4 4 4 4</vcount><p>{quads}</p></polylist>'}
box = '<instance_geometry url="#box"/>'
nodes = {"one": f"<node>{box}</node>", "moved": f"<node><translate>100 0 0</translate>{box}</node>",
         "two": f"<node>{box}</node><node><translate>100 0 0</translate>{box}</node>",
         "scaled": f"<node><scale>3 1 1</scale>{box}</node>"}
print(f'''<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><created>2026-01-01T00:00:00Z</created>
<modified>2026-01-01T00:00:00Z</modified><unit meter="0.001" name="millimeter"/><up_axis>Z_UP</up_axis></asset><library_geometries>
<geometry id="box" name="box"><mesh><source id="p"><float_array id="a" count="24">{corners}</float_array><technique_common>
<accessor source="#a" count="8" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>{faces[sys.argv[2]]}</mesh></geometry>
</library_geometries><library_visual_scenes><visual_scene id="s">{nodes[sys.argv[1]]}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>''')
PY
{
  while read -r scene faces; do
    python3 assembly.py "$scene" "$faces" >part.dae
    ctmconv part.dae part.obj >messages
    echo "$scene, $faces: $(grep -c '^f' part.obj) triangles, $(extent part.obj)"
  done <<'SCENES'
one triangles
moved triangles
two triangles
scaled triangles
one quads
SCENES
  printf 'v 123000 0 0\nv 123010.4 0 0\nv 123000 10.4 0\nf 1 2 3\n' >far.obj
  ctmconv far.obj far.dae >messages
  grep -q 'up_axis\|<unit' far.dae || echo 'written: neither unit nor axis'
  grep -o 'count="9">[-0-9. ]*' far.dae
} >seen
expect_in seen <<'END'
one, triangles: 12 triangles, 0..10 0..10 0..10
moved, triangles: 12 triangles, 0..10 0..10 0..10
two, triangles: 12 triangles, 0..10 0..10 0..10
scaled, triangles: 12 triangles, 0..10 0..10 0..10
one, quads: 0 triangles, 0..0 0..0 0..0
written: neither unit nor axis
count="9">123000 0 0 123010 0 0 123000 10.4 0 
END
