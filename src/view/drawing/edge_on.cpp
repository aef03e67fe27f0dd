// SPDX-License-Identifier: Apache-2.0
#include "drawing/edge_on.hpp"

#include <cmath>
#include <cstddef>

#include "drawing/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::drawing {

namespace {

std::vector<char> faces_edge_on(const world::World& world, std::size_t model, const Vec3& viewer) {
  const world::Placed& placed = world.models[model];
  if (placed.part == nullptr) return {};
  std::vector<double> seen(placed.part->faces.size(), 0), all(seen);
  const std::vector<int> faces = world::faces_of_triangles(placed);
  for (std::size_t t = 0; t < faces.size(); ++t) {
    if (faces[t] < 0) continue;
    const auto& [a, b, c] = world.triangles[static_cast<std::size_t>(world.first_triangle[model]) + t];
    const Vec3 area = glm::cross(world.points[b] - world.points[a], world.points[c] - world.points[a]);
    seen[faces[t]] += std::abs(glm::dot(area, viewer));
    all[faces[t]] += glm::length(area);
  }
  std::vector<char> edge_on(seen.size());
  for (std::size_t f = 0; f < seen.size(); ++f) edge_on[f] = seen[f] < seen_edge_on * all[f] ? 1 : 0;
  return edge_on;
}

}  // namespace

FacesEdgeOn::FacesEdgeOn(const visibility::ResolvedView& lines) : world_(lines.world) {
  const projection::Projection& projection = lines.view.projection;
  edge_on_.resize(world_.models.size());
  if (projection.central) return;
  const Vec3 viewer = glm::normalize(projection.projector);
  for (std::size_t model = 0; model < edge_on_.size(); ++model) edge_on_[model] = faces_edge_on(world_, model, viewer);
}

bool FacesEdgeOn::has_step(const edges::FeatureEdge& edge) const {
  const std::vector<char>& edge_on = edge_on_[edge.model];
  if (edge.kind != EdgeKind::contour || edge.mesh_edge < 0 || edge_on.empty()) return false;
  const world::Placed& placed = world_.models[edge.model];
  const mesh::Mesh& whole = placed.mesh->whole();
  const mesh::MeshEdge* found = &placed.mesh->edges[edge.mesh_edge];
  if (&whole != placed.mesh.get()) found = whole.edge_between(placed.mesh->origin_of(*found).vertex);
  if (found == nullptr || found->count == 0) return false;
  if (placed.part->border_at(found - whole.edges.data()) != nullptr) return false;
  const int face = placed.part->face_of_triangle[whole.triangles_of(*found).front()];
  return face >= 0 && edge_on[face] != 0;
}

}  // namespace epura::drawing
