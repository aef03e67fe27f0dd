#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# ADMesh 0.98.4 refuses an ASCII STL of two solids, as CAD programs write assemblies; numpy-stl 2.8 (Debian's 2.9.0-2) reads the first
# solid by Mesh.from_file and says nothing. OpenSCAD 2021.01 and assimp 5.2.5 read both. Believed: all read both.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages admesh=0.98.4-2 python3-stl=2.9.0-2+b3 assimp-utils=5.2.5~ds0-1+b1
{ box_stl first 0; box_stl second 50; } >two.stl
box_stl one 0 >one.stl
for file in one two; do
  admesh "$file.stl" >"$file.log" 2>&1 && code=0 || code=$?
  echo "$file: ADMesh ends with $code: $(grep -E 'Number of facets|wrong' "$file.log" | head -n 1 | tr -s ' ')"
  echo "$file: numpy-stl $(PYTHONPATH=root/usr/lib/python3/dist-packages root/usr/bin/python3.11 -W ignore -c '
import sys
from stl import mesh
print(len(mesh.Mesh.from_file(sys.argv[1])))' "$file.stl") facets, assimp $(assimp info "$file.stl" | awk '/^Faces:/ { print $2 }')"
done >seen 2>&1
expect_in seen <<'END'
one: ADMesh ends with 0: Number of facets : 12 12
one: numpy-stl 12 facets, assimp 12
two: ADMesh ends with 1: Something is syntactically very wrong with this ASCII STL!: Success
two: numpy-stl 12 facets, assimp 24
END
