#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# assimp 5.2.5 writes an empty line after each facet of an ASCII STL, which is white space like any other. gmsh 4.8.4 counts lines and
# falls out of step: of 9 facets it reads 4 wrong ones, with success, and of many other numbers of facets it reads none. Believed: gmsh
# reads what assimp writes, as ADMesh 0.98.4 does; without the empty lines it does.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1 gmsh=4.8.4+ds2-3 admesh=0.98.4-2
winding_stair() {  # FACETS
  echo 'v 0 0 0'
  awk -v n="$1" 'BEGIN { for (i = 0; i <= n; ++i) printf "v %g %g %d\n", 10 * cos(i / 4), 10 * sin(i / 4), i
                         for (i = 0; i < n; ++i) printf "f 1 %d %d\n", i + 2, i + 3 }'
}
area() {  # FILE: of an ASCII STL
  awk '/vertex/ { v[n++ % 9] = $2; v[n++ % 9] = $3; v[n++ % 9] = $4 }
    /endfacet/ { for (i = 0; i < 3; ++i) { a[i] = v[3 + i] - v[i]; b[i] = v[6 + i] - v[i] }; ++facets
      area += sqrt((a[1] * b[2] - a[2] * b[1]) ^ 2 + (a[2] * b[0] - a[0] * b[2]) ^ 2 + (a[0] * b[1] - a[1] * b[0]) ^ 2) / 2 }
    END { printf "%d facets of %.1f\n", facets, area }' "$1"
}
for count in 4 9 12; do
  winding_stair $count >stair.obj
  assimp export stair.obj stair.stl >assimp.log
  sed '/^$/d' stair.stl >dense.stl
  admesh --no-check -a admesh.stl stair.stl >admesh.log
  echo "assimp: $(area stair.stl); ADMesh: $(area admesh.stl)"
  for name in stair dense; do
    gmsh $name.stl -0 -format stl -o $name-gmsh.stl >gmsh.log 2>&1 && success=succeeds || success=fails
    echo "  gmsh $success on $name: $(grep -q '^Error' gmsh.log && sed -n 's/^Error *: Wrong/wrong/p' gmsh.log || area $name-gmsh.stl)"
  done
done >seen
expect_in seen <<'END'
assimp: 4 facets of 54.5; ADMesh: 4 facets of 54.5
  gmsh fails on stair: wrong number of points (8) in STL file for solid 0 AssimpScene
  gmsh succeeds on dense: 4 facets of 54.5
assimp: 9 facets of 132.9; ADMesh: 9 facets of 132.9
  gmsh succeeds on stair: 4 facets of 28.7
  gmsh succeeds on dense: 9 facets of 132.9
assimp: 12 facets of 189.0; ADMesh: 12 facets of 189.0
  gmsh fails on stair: wrong number of points (20) in STL file for solid 0 AssimpScene
  gmsh succeeds on dense: 12 facets of 189.0
END
