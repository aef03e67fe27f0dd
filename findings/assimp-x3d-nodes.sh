#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# assimp 5.2.5 leaves out of an X3D what stands in CADAssembly, CADLayer, CADPart and CADFace, which X3D has for what comes from CAD, in
# LOD, Collision and Anchor, quads of IndexedQuadSet, faces whose coordinates are doubles, and faces whose indices stand behind commas
# without blanks. It names none of them and ends with success; of an unknown TriangleStripSet it says so. Groups and transforms are right.
# Believed: all boxes (ISO/IEC 19775-1, 10 and 32; commas between whole numbers are blanks, ISO/IEC 19776-1, 5.1).
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1
corners='0 0 0 10 0 0 0 10 0 10 10 0 0 0 10 10 0 10 0 10 10 10 10 10'
faces='0 2 3 1 -1 4 5 7 6 -1 0 1 5 4 -1 2 6 7 3 -1 0 4 6 2 -1 1 3 7 5 -1'
box="<Shape><IndexedFaceSet coordIndex='$faces'><Coordinate point='$corners'/></IndexedFaceSet></Shape>"
moved="<Transform translation='30 0 0'>$box</Transform>"
beside() {  # WHAT NODE: a box at the origin, and this
  printf '<?xml version="1.0" encoding="UTF-8"?>\n<X3D profile="Full" version="3.3"><Scene>%s%s</Scene></X3D>\n' "$box" "$2" >scene.x3d
  rm -f scene.obj
  assimp export scene.x3d scene.obj >messages 2>&1 || { echo "$1: $(grep -o 'ERROR.*\|Unknown.*' messages | tail -n 1)"; return 0; }
  echo "$1: $(grep -c '^f ' scene.obj) faces, $(extent scene.obj); warnings: $(grep -ciE 'warn|skip|ignor|unknown' messages || true)"
}
{
  echo "right would be 12 faces, 0..40 0..10 0..10 each"
  beside "a moved box" "$moved"
  beside "Group" "<Group>$moved</Group>"
  for node in CADAssembly CADLayer LOD Collision Anchor; do beside "$node" "<$node>$moved</$node>"; done
  beside "CADPart" "<CADAssembly><CADPart translation='30 0 0'><CADFace>$box</CADFace></CADPart></CADAssembly>"
  quads=${moved//IndexedFaceSet/IndexedQuadSet}
  quads=${quads/coordIndex/index}
  beside "IndexedQuadSet" "${quads// -1/}"
  beside "CoordinateDouble" "${moved/Coordinate point/CoordinateDouble point}"
  beside "commas and blanks" "${moved/$faces/${faces// /, }}"
  beside "commas" "${moved/$faces/${faces// /,}}"
  beside "TriangleStripSet" "<Shape><TriangleStripSet stripCount='4'><Coordinate point='30 0 0 40 0 0 30 10 0 40 10 0'/></TriangleStripSet></Shape>"
} >seen
expect_in seen <<'END'
right would be 12 faces, 0..40 0..10 0..10 each
a moved box: 12 faces, 0..40 0..10 0..10; warnings: 0
Group: 12 faces, 0..40 0..10 0..10; warnings: 0
CADAssembly: 6 faces, 0..10 0..10 0..10; warnings: 0
CADLayer: 6 faces, 0..10 0..10 0..10; warnings: 0
LOD: 6 faces, 0..10 0..10 0..10; warnings: 0
Collision: 6 faces, 0..10 0..10 0..10; warnings: 0
Anchor: 6 faces, 0..10 0..10 0..10; warnings: 0
CADPart: 6 faces, 0..10 0..10 0..10; warnings: 0
IndexedQuadSet: 6 faces, 0..10 0..10 0..10; warnings: 0
CoordinateDouble: 6 faces, 0..10 0..10 0..10; warnings: 0
commas and blanks: 12 faces, 0..40 0..10 0..10; warnings: 0
commas: 6 faces, 0..30 0..10 0..10; warnings: 0
TriangleStripSet: ERROR: Failed to load file: Unknown node "TriangleStripSet" in Shape.
END
