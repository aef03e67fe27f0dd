#include "mesh/mesh.hpp"

namespace epura {

std::array<int, 3> Mesh::corners(int triangle) const {
  std::array<int, 3> corners;
  auto halfedge = surface.halfedge_handle(OpenMesh::FaceHandle(triangle));
  for (int& corner : corners) {
    corner = vertex_of[surface.to_vertex_handle(halfedge).idx()];
    halfedge = surface.next_halfedge_handle(halfedge);
  }
  return corners;
}

}  // namespace epura
