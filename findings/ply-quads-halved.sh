#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A box of 10 x 20 x 30 whose six faces are quads in PLY, as modellers write it: gmsh 4.8.4 and OpenCTM 1.0.3 (ctmconv) read the first
# triangle of each quad and say nothing: half the surface is gone. Believed: 12 triangles of 2200, as assimp 5.2.5 has them. gmsh does
# not heed the names of the properties either: after a normal, x, y and z are the normal's.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages gmsh=4.8.4+ds2-3 openctm-tools=1.0.3+dfsg1-2.1+b3 assimp-utils=5.2.5~ds0-1+b1
box_ply() {  # PROPERTIES VALUES
  printf 'ply\nformat ascii 1.0\nelement vertex 8\n'
  for name in $1 x y z; do echo "property float $name"; done
  printf 'element face 6\nproperty list uchar int vertex_indices\nend_header\n'
  for z in 0 30; do for y in 0 20; do for x in 0 10; do echo $2 $x $y $z; done; done; done
  printf '4 %s\n' '0 2 3 1' '4 5 7 6' '0 1 5 4' '2 6 7 3' '0 4 6 2' '1 3 7 5'
}
box_ply '' '' >box.ply
box_ply 'nx ny nz' '0 0 1' >normals.ply
area() {  # NAME FILE: of the triangles of an ASCII STL
  awk -v name="$1" '/vertex/ { v[n++ % 9] = $2; v[n++ % 9] = $3; v[n++ % 9] = $4 }
    /endfacet/ { for (i = 0; i < 3; ++i) { a[i] = v[3 + i] - v[i]; b[i] = v[6 + i] - v[i] }; ++facets
      area += sqrt((a[1] * b[2] - a[2] * b[1]) ^ 2 + (a[2] * b[0] - a[0] * b[2]) ^ 2 + (a[0] * b[1] - a[1] * b[0]) ^ 2) / 2 }
    END { printf "%s: %d triangles of %g\n", name, facets, area }' "$2"
}
for file in box normals; do
  assimp export $file.ply $file-assimp.stl >assimp.log
  gmsh $file.ply -0 -format stl -o $file-gmsh.stl >gmsh.log
  ctmconv $file.ply $file.obj >ctm.log
  area "$file, assimp" $file-assimp.stl
  area "$file, gmsh" $file-gmsh.stl
  echo "$file, OpenCTM: $(grep -c '^f' $file.obj) triangles"
  grep -iE 'warn|error' gmsh.log ctm.log || echo "$file: no word of it"
done >seen
expect_in seen <<'END'
box, assimp: 12 triangles of 2200
box, gmsh: 6 triangles of 1100
box, OpenCTM: 6 triangles
box: no word of it
normals, assimp: 12 triangles of 2200
normals, gmsh: 6 triangles of 0
normals, OpenCTM: 6 triangles
normals: no word of it
END
