// SPDX-License-Identifier: Apache-2.0
#include "sizes/hexagon_chamfers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "features/tolerances.hpp"
#include "world/placed_part.hpp"

namespace epura::sheet {

namespace {

using features::HexagonFeature;

/// A plane beside a hexagon.
struct PlaneBeside {
  Vec3 point, normal;
};

// Whether it leans from the axis towards one of the flats.
bool leans_to_flat(const PlaneBeside& plane, const HexagonFeature& hexagon) {
  const Vec3 across = plane.normal - glm::dot(plane.normal, hexagon.axis) * hexagon.axis;
  if (!(glm::length(across) > features::parallel)) return false;
  return std::any_of(hexagon.normals.begin(), hexagon.normals.end(),
                     [&](const Vec3& normal) { return features::are_parallel(glm::normalize(across), normal); });
}

// Whether a turn about the axis of a hexagon takes one to the other.
bool are_turned(const PlaneBeside& a, const PlaneBeside& b, const HexagonFeature& hexagon) {
  const auto off = [&](const PlaneBeside& plane) { return glm::dot(plane.point - hexagon.centre, plane.normal); };
  return std::abs(glm::dot(a.normal, hexagon.axis) - glm::dot(b.normal, hexagon.axis)) <= features::parallel &&
         features::are_same(off(a), off(b)) && leans_to_flat(a, hexagon) && leans_to_flat(b, hexagon);
}

bool is_parallel_to_world(const Vec3& normal) {
  return std::min({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)}) <= features::parallel;
}

// The chamfer that is equal to a plane; -1 if there is none.
int bevel_like(const PlaneBeside& plane, int model, const features::PartFeatures& features) {
  for (std::size_t i = 0; i < features.bevels.size(); ++i) {
    const features::BevelFeature& bevel = features.bevels[i];
    if (bevel.model != model || !bevel.is_chamfer) continue;
    const auto is_beside = [&](const HexagonFeature& hexagon) {
      return hexagon.model == model && are_turned({bevel.ends[0], bevel.normal}, plane, hexagon);
    };
    if (std::any_of(features.hexagons.begin(), features.hexagons.end(), is_beside)) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace

bool HexagonChamfer::is_face(const Vec3& origin, const Vec3& direction) const {
  return glm::dot(direction, normal) > 0 && features::are_parallel(direction, normal) &&
         std::abs(glm::dot(origin - point, normal)) <= slack;
}

std::vector<HexagonChamfer> find_hexagon_chamfers(const DimensionSubject& subject) {
  std::vector<HexagonChamfer> chamfers;
  const features::PartFeatures& features = subject.features;
  const std::vector<world::Placed>& models = subject.world.models;
  const double slack = features::same_size * glm::length(subject.world.box.size());
  for (std::size_t model = 0; model < models.size() && !features.hexagons.empty(); ++model) {
    const auto part = models[model].part == nullptr ? std::nullopt : world::place_part(models[model]);
    if (!part) continue;
    for (const epura::surfaces::PartFace& face : part->faces) {
      const epura::surfaces::PartSurface& plane = face.surface;
      if (plane.kind != epura::surfaces::SurfaceKind::plane || is_parallel_to_world(plane.axis)) continue;
      if (const int bevel = bevel_like({plane.origin, plane.axis}, static_cast<int>(model), features); bevel >= 0)
        chamfers.push_back({bevel, plane.origin, plane.axis, slack});
    }
  }
  return chamfers;
}

}  // namespace epura::sheet
