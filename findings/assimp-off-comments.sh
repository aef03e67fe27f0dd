#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# A tetrahedron of OFF with a comment line between its vertices and faces, which OFF allows anywhere: assimp 5.2.5 takes the comment for
# one of the four faces and leaves the last face out, with success. Comments elsewhere cost nothing. Believed: four faces, as OpenSCAD
# 2021.01 and OpenCTM 1.0.3 have them.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1 openscad=2021.01-6 openctm-tools=1.0.3+dfsg1-2.1+b3
head='OFF\n4 4 6\n'
vertices='0 0 0\n10 0 0\n0 10 0\n0 0 10\n'
faces='3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n'
printf "$head$vertices$faces" >plain.off
printf "$head# corners\n$vertices$faces" >before-vertices.off
printf "$head$vertices# sides\n$faces" >before-faces.off
for name in plain before-vertices before-faces; do
  assimp export $name.off $name-assimp.stl >assimp.log || echo "$name: assimp failed"
  echo "import(\"$name.off\");" >$name.scad
  openscad -o $name-openscad.stl $name.scad 2>openscad.log
  ctmconv $name.off $name.obj >ctm.log
  echo "$name: assimp $(grep -c outer $name-assimp.stl), OpenSCAD $(grep -c outer $name-openscad.stl), OpenCTM $(grep -c '^f' $name.obj)"
done >seen
expect_in seen <<'END'
plain: assimp 4, OpenSCAD 4, OpenCTM 4
before-vertices: assimp 4, OpenSCAD 4, OpenCTM 4
before-faces: assimp 3, OpenSCAD 4, OpenCTM 4
END
