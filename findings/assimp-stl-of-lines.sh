#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# An OBJ of a tetrahedron with one of its edges as a line, as CAD programs write models with edges: assimp 5.2.5 makes of the line an STL
# facet with two corners and a normal "nan", and a binary STL 12 bytes too short for its count, with success. ADMesh 0.98.4
# then refuses the whole file. Believed: lines are left out, since STL has none.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages assimp-utils=5.2.5~ds0-1+b1 admesh=0.98.4-2
printf 'v 0 0 0\nv 10 0 0\nv 0 10 0\nv 0 0 10\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n' >faces.obj
{ cat faces.obj; echo 'l 1 2'; } >line.obj
for name in faces line; do
  assimp export $name.obj $name.stl >assimp.log && echo "$name: assimp succeeds"
  assimp export $name.obj $name.stlb -fstlb >assimp.log
  echo "$name: $(grep -c facet.normal $name.stl) facets, $(grep -c vertex $name.stl) corners"
  python3 - $name.stlb <<'PY'
import struct, sys
data = open(sys.argv[1], "rb").read()
print(f"binary: {len(data)} bytes, {84 + 50 * struct.unpack_from('<I', data, 80)[0]} needed")
PY
  admesh $name.stl >admesh.log 2>&1 && echo "admesh reads $name.stl" || echo "admesh: $(head -n 1 admesh.log)"
done >seen
expect_in seen <<'END'
faces: assimp succeeds
faces: 4 facets, 12 corners
binary: 284 bytes, 284 needed
admesh reads faces.stl
line: assimp succeeds
line: 5 facets, 14 corners
binary: 322 bytes, 334 needed
admesh: Something is syntactically very wrong with this ASCII STL!: Success
END
