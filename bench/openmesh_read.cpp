// SPDX-License-Identifier: Apache-2.0
// Measures how long OpenMesh takes to read a model:  openmesh_read MODEL
// Reads doubles, and nothing but the surface.
#include <OpenMesh/Core/IO/MeshIO.hh>
// Must follow the readers.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "mesh/openmesh.hpp"
#include "say.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: openmesh_read MODEL\n", stderr);
    return 2;
  }
  const double start = epura::bench::now();
  epura::mesh::Surface surface;
  if (!OpenMesh::IO::read_mesh(surface, argv[1])) {
    std::fprintf(stderr, "openmesh_read: cannot read %s\n", argv[1]);
    return 2;
  }
  epura::bench::say_seconds("read", epura::bench::now() - start);
  epura::bench::say_count("triangles", surface.n_faces());
}
