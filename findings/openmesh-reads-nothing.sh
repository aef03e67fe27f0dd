#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# OpenMesh 9.0: read_mesh returns true and gives a mesh without faces for an OFF with a comment between its first line and the counts, and for an OBJ
# whose face goes on in the next line after a backslash. Believed: both, which the formats allow, are read, or false is returned.
. "$(dirname "$(realpath "$0")")/packages.sh"
debian_packages libopenmesh-dev=9.0-4+b1
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >plain.off
printf 'OFF\n# one triangle\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >comments.off
printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n' >colour.off
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n' >plain.obj
printf 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 \\\n3 4\n' >continued.obj
cat >read.cpp <<'CPP'
#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <cstdio>

int main() {
  for (const char* file : {"plain.off", "comments.off", "colour.off", "plain.obj", "continued.obj"}) {
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    const bool read = OpenMesh::IO::read_mesh(mesh, file);
    std::printf("%s: %s, %zu faces\n", file, read ? "true" : "false", mesh.n_faces());
  }
}
CPP
c++ -std=c++17 -I root/usr/include read.cpp -L root/usr/lib/x86_64-linux-gnu -lOpenMeshCore -o read
./read 2>/dev/null >seen
expect_in seen <<'END'
plain.off: true, 1 faces
comments.off: true, 0 faces
colour.off: true, 1 faces
plain.obj: true, 1 faces
continued.obj: true, 0 faces
END
