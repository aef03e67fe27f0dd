#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# tovrmlx3d 4.2.0 (converter of view3dscene, Castle Game Engine) drops the unit and the upper axis of a COLLADA and the unit of an X3D: in what it
# writes, which is in metres with y up, a part of 10 x 20 x 30 mm with z up is 10 x 20 x 30 m and lies on its back. It ends with success, and
# writes the version of the COLLADA into the file. Places and turns of nodes are right. Believed: 0.01 x 0.03 x 0.02 m (COLLADA 1.4.1,
# asset), and the statement UNIT kept or heeded (ISO/IEC 19775-1, 4.3.6).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages view3dscene=4.2.0-1
collada() {  # UNIT AXIS
  cat <<END
<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><created>2026-01-01T00:00:00</created><modified>2026-01-01T00:00:00</modified><unit meter="$1"/><up_axis>$2</up_axis></asset>
  <library_geometries><geometry id="part"><mesh>
    <source id="places"><float_array id="numbers" count="12">0 0 0 10 0 0 0 20 0 0 0 30</float_array><technique_common><accessor source="#numbers" count="4" stride="3">
      <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
    <vertices id="corners"><input semantic="POSITION" source="#places"/></vertices>
    <triangles count="4"><input semantic="VERTEX" source="#corners" offset="0"/><p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>
  </mesh></geometry></library_geometries>
  <library_visual_scenes><visual_scene id="scene"><node><instance_geometry url="#part"/></node></visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
END
}
x3d() {  # STATEMENT
  printf '#X3D V3.3 utf8\nPROFILE Interchange\n%s\nShape { geometry Box { size 10 20 30 } }\n' "$1"
}
told() {  # NAME FILE
  tovrmlx3d "$2" >converted.x3dv
  echo "$1: $(grep -oE '^[[:space:]]*(UNIT|rotation|scale|matrix|size|[0-9. ]+,?$).*' converted.x3dv | tr -s '\t\n ' ' ')"
}
collada 1 Y_UP >metres.dae
collada 0.001 Y_UP >millimetres.dae
collada 0.001 Z_UP >upright.dae
x3d '' >metres.x3dv
x3d 'UNIT length millimetre 0.001' >millimetres.x3dv
{
  told "COLLADA, metres, y up" metres.dae
  told "COLLADA, millimetres, y up" millimetres.dae
  told "COLLADA, millimetres, z up" upright.dae
  told "X3D, metres" metres.x3dv
  told "X3D, millimetres" millimetres.x3dv
} >seen
expect_in seen <<'END'
COLLADA, metres, y up:  0 0 0, 10 0 0, 0 20 0, 0 0 30, 
COLLADA, millimetres, y up:  0 0 0, 10 0 0, 0 20 0, 0 0 30, 
COLLADA, millimetres, z up:  0 0 0, 10 0 0, 0 20 0, 0 0 30, 
X3D, metres:  size 10 20 30 
X3D, millimetres:  size 10 20 30 
END
