#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# FreeCAD 0.20.2 reads of a PLY only faces of three corners, and only if no edges stand before them: a square of one quad, or of a strip of
# triangles, becomes an empty mesh; with a list of edges before the faces, as PLY allows any elements in any order, it has three points and
# one facet. Nothing is said. Believed: 4 points, 2 facets of 100 mm2, as for edges after the faces.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libfreecad-python3-0.20=0.20.2+dfsg1-4+deb12u1
export PYTHONPATH=$work/root/usr/lib/python3/dist-packages:$work/root/usr/lib/freecad-python3/lib HOME=$work
square() {  # NAME ELEMENT...: each in words "edge", "triangles", "quad" or "strip"
  local file=$1.ply element rows=
  shift
  printf '%s\n' ply 'format ascii 1.0' 'element vertex 4' 'property float x' 'property float y' 'property float z' >"$file"
  for element; do
    case $element in
      edge) printf '%s\n' 'element edge 1' 'property int vertex1' 'property int vertex2'; rows+=$'0 1\n' ;;
      triangles) printf '%s\n' 'element face 2' 'property list uchar int vertex_indices'; rows+=$'3 0 1 2\n3 0 2 3\n' ;;
      quad) printf '%s\n' 'element face 1' 'property list uchar int vertex_indices'; rows+=$'4 0 1 2 3\n' ;;
      strip) printf '%s\n' 'element tristrips 1' 'property list int int vertex_indices'; rows+=$'4 0 1 3 2\n' ;;
    esac >>"$file"
  done
  printf '%s\n' end_header '0 0 0' '10 0 0' '10 10 0' '0 10 0' "${rows%$'\n'}" >>"$file"
}
square 'triangles' triangles
square 'edges after' triangles edge
square 'edges before' edge triangles
square 'quad' quad
square 'strip' strip
cat >faces.py <<'PY'
import FreeCAD, Mesh

for name in ("triangles", "edges after", "edges before", "quad", "strip"):
    mesh = Mesh.Mesh(name + ".ply")
    print(f"{name}: {mesh.CountPoints} points, {mesh.CountFacets} facets of {mesh.Area:.0f} mm2")
PY
python3 faces.py >seen 2>messages
cat messages >>seen
expect_in seen <<'END'
triangles: 4 points, 2 facets of 100 mm2
edges after: 4 points, 2 facets of 100 mm2
edges before: 3 points, 1 facets of 50 mm2
quad: 0 points, 0 facets of 0 mm2
strip: 0 points, 0 facets of 0 mm2
END
