// SPDX-License-Identifier: Apache-2.0
// Refines a model without changing its shape, by Loop's subdivision:  subdivide MODEL STEPS FILE.ply
// Each step divides a triangle into four (Loop, Smooth Subdivision Surfaces Based on Triangles, 1987).
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// Must follow the mesh.
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <cstdio>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "mesh/openmesh.hpp"
#include "mesh/read.hpp"
#include "scene.hpp"

namespace {

using namespace epura;

bench::Scene subdivided(mesh::Surface surface, int steps) {
  OpenMesh::Subdivider::Uniform::LoopT<mesh::Surface, double> loop;
  loop.attach(surface);
  loop(static_cast<std::size_t>(steps));
  loop.detach();

  bench::Scene scene;
  for (const auto vertex : surface.vertices()) {
    const OpenMesh::Vec3d& p = surface.point(vertex);
    scene.add(p[0], p[1], p[2]);
  }
  for (const auto face : surface.faces()) {
    std::array<int, 3> triangle{};
    std::size_t k = 0;
    for (const auto vertex : surface.fv_range(face)) triangle[k++] = vertex.idx();
    scene.triangles.push_back(triangle);
  }
  return scene;
}

}  // namespace

int main(int argc, char** argv) {
  const auto steps = argc == 4 ? parse_integer(argv[2]) : std::nullopt;
  if (!steps || *steps < 0 || *steps > 10) {
    std::fputs("usage: subdivide MODEL STEPS FILE.ply\n", stderr);
    return static_cast<int>(ErrorKind::input);
  }
  try {
    write_file(argv[3], bench::ply_bytes(
                            subdivided(mesh::to_openmesh(mesh::read_mesh(argv[1])).surface, static_cast<int>(*steps))));
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "subdivide: %s\n", error.what());
    return static_cast<int>(error.kind());
  }
}
