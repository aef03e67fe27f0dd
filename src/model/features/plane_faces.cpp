// SPDX-License-Identifier: Apache-2.0
#include "features/plane_faces.hpp"

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "features/tolerances.hpp"

namespace epura::features {

std::vector<PlaneFace> find_plane_faces(const world::World& world, int model, const world::PlacedPart& part) {
  const world::Placed& placed = world.models[model];
  const mesh::Mesh& mesh = placed.mesh->whole();
  std::vector<PlaneFace> planes;
  for (const surfaces::PartFace& face : part.faces) planes.push_back({face.body, face.surface.axis, {}});
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const int face = placed.part->face_of_triangle[t];
    if (face < 0 || part.faces[face].surface.kind != surfaces::SurfaceKind::plane) continue;
    const Vec3 normal = glm::abs(part.faces[face].surface.axis);
    if (std::min({normal.x, normal.y, normal.z}) > parallel) continue;
    for (const int v : mesh.triangle(t)) planes[face].vertices.push_back(v);
  }
  for (PlaneFace& plane : planes) {
    std::sort(plane.vertices.begin(), plane.vertices.end());
    plane.vertices.erase(std::unique(plane.vertices.begin(), plane.vertices.end()), plane.vertices.end());
    for (const int v : plane.vertices) plane.corners.emplace_back(Vec3(placed.to_world * Vec4(mesh.point(v), 1)));
  }
  return planes;
}

std::vector<std::vector<FaceBorder>> borders_of_faces(const world::Placed& placed) {
  check(placed.part != nullptr, "a model has faces if its part is recognised");
  std::vector<std::vector<FaceBorder>> beside(placed.part->faces.size());
  for (const surfaces::PartBorder& border : placed.part->borders) {
    const auto [a, b] = border.faces;
    if (a < 0 || a == b) continue;
    const bool tangent = border.kind == surfaces::BorderKind::tangent;
    beside[static_cast<std::size_t>(a)].push_back({b, tangent});
    beside[static_cast<std::size_t>(b)].push_back({a, tangent});
  }
  return beside;
}

}  // namespace epura::features
