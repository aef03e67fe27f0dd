// SPDX-License-Identifier: Apache-2.0
#include "mesh/openmesh.hpp"

#include <numeric>
#include <span>

#include "base/parallel.hpp"
#include "mesh/edge_table.hpp"

namespace epura::mesh {

namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

struct SurfaceEdges {
  std::vector<HalfedgeHandle> of;  ///< half-edge of the table -> half-edge of the surface
  int count = 0;
};

/// Creates one edge for two triangles that remain joined, otherwise one for each half-edge. They are numbered in order
/// of the triangles, not of the table, which keeps neighbours close to each other in memory.
SurfaceEdges number_edges(std::span<const int> corners, const EdgeTable& table) {
  SurfaceEdges numbered;
  numbered.of.resize(corners.size());  // not yet valid
  for (const MeshEdge& edge : table.edges)
    if (is_two_sided(table, edge, corners)) {
      const auto halfedges = table.halfedges_of(edge);
      numbered.of[halfedges[1]] = HalfedgeHandle(halfedges[0]);  // for now, the later one refers to the earlier one
    }
  for (HalfedgeHandle& own : numbered.of)
    own = own.is_valid() ? HalfedgeHandle(numbered.of[own.idx()].idx() + 1) : HalfedgeHandle(2 * numbered.count++);
  return numbered;
}

void link_faces(Surface& surface, const std::vector<HalfedgeHandle>& of) {
  parallel_for(surface.n_faces(), grain::light, [&](std::size_t first, std::size_t last) {
    for (std::size_t t = first; t < last; ++t) {
      const FaceHandle face(static_cast<int>(t));
      // The last half-edge ends at corner 0, so that OpenMesh's circulators start there.
      surface.set_halfedge_handle(face, of[3 * t + 2]);
      for (std::size_t k = 0; k < 3; ++k) {
        surface.set_face_handle(of[3 * t + k], face);
        surface.set_next_halfedge_handle(of[3 * t + k], of[3 * t + (k + 1) % 3]);
      }
    }
  });
}

/// Links the triangles around one vertex, starting at the outgoing half-edge at their right end (any half-edge if they
/// form a ring).
void link_fan(Surface& surface, HalfedgeHandle right, VertexHandle vertex) {
  const HalfedgeHandle border_in = surface.opposite_halfedge_handle(right);
  for (HalfedgeHandle outgoing = right;;) {
    const HalfedgeHandle incoming = surface.prev_halfedge_handle(outgoing);
    surface.set_vertex_handle(incoming, vertex);
    outgoing = surface.opposite_halfedge_handle(incoming);
    if (outgoing == right) return surface.set_halfedge_handle(vertex, right);
    if (!surface.is_boundary(outgoing)) continue;
    // OpenMesh expects a boundary half-edge at the vertex.
    surface.set_vertex_handle(border_in, vertex);
    surface.set_next_halfedge_handle(border_in, outgoing);
    return surface.set_halfedge_handle(vertex, outgoing);
  }
}

HalfedgeHandle right_end_of_fan(const Surface& surface, HalfedgeHandle start) {
  HalfedgeHandle outgoing = start;
  while (!surface.is_boundary(surface.opposite_halfedge_handle(outgoing))) {
    outgoing = surface.next_halfedge_handle(surface.opposite_halfedge_handle(outgoing));
    if (outgoing == start) break;
  }
  return outgoing;
}

}  // namespace

HalfedgeMesh to_openmesh(const Mesh& mesh) {
  const EdgeTable table = make_edge_table(mesh.corners, mesh.polygon, static_cast<int>(mesh.points.size()));
  const SurfaceEdges edges = number_edges(mesh.corners, table);
  HalfedgeMesh made;
  Surface& surface = made.surface;
  // Reserves room for copies of vertices; memory that is never written costs nothing.
  surface.reserve(2 * mesh.points.size(), static_cast<std::size_t>(edges.count), mesh.polygon.size());
  surface.resize(mesh.points.size(), static_cast<std::size_t>(edges.count), mesh.polygon.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const auto& [x, y, z] = mesh.points[v];
    surface.set_point(VertexHandle(static_cast<int>(v)), {x, y, z});
  }
  made.vertex_of.resize(mesh.points.size());
  std::iota(made.vertex_of.begin(), made.vertex_of.end(), 0);
  link_faces(surface, edges.of);

  for (std::size_t h = 0; h < mesh.corners.size(); ++h) {
    if (surface.to_vertex_handle(surface.prev_halfedge_handle(edges.of[h])).is_valid()) continue;  // fan already linked
    VertexHandle vertex(mesh.corners[h]);
    if (!surface.is_isolated(vertex)) {
      vertex = surface.new_vertex();
      surface.set_point(vertex, surface.point(VertexHandle(mesh.corners[h])));
      made.vertex_of.push_back(mesh.corners[h]);
    }
    link_fan(surface, right_end_of_fan(surface, edges.of[h]), vertex);
  }
  return made;
}

}  // namespace epura::mesh
