// How long OpenMesh takes to read a model:  openmesh_read MODEL
// In double, with nothing asked of it but the surface. Says the seconds on stderr as epura's --timings does.
#include <OpenMesh/Core/IO/MeshIO.hh>
// After the readers, which must know of it.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <chrono>
#include <cstdio>

#include "mesh/surface.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: openmesh_read MODEL\n", stderr);
    return 2;
  }
  const auto start = std::chrono::steady_clock::now();
  epura::Surface surface;
  OpenMesh::IO::Options options = OpenMesh::IO::Options::Binary;
  if (!OpenMesh::IO::read_mesh(surface, argv[1], options)) {
    std::fprintf(stderr, "openmesh_read: cannot read %s\n", argv[1]);
    return 2;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  std::fprintf(stderr, "%-12s %8.4f s\n%-12s %8zu\n", "read", seconds.count(), "triangles", surface.n_faces());
}
