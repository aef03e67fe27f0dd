// SPDX-License-Identifier: Apache-2.0
#include "features/cavities.hpp"

#include <algorithm>
#include <cstddef>

#include "features/tolerances.hpp"

namespace epura::features {

bool Cavity::holds(const Vec3& point) const {
  const auto flat = [this](const Vec3& d) { return d - glm::dot(d, axis) * axis; };
  const Vec3 d = flat(point - centres[0]), along = flat(centres[1] - centres[0]);
  const double square = glm::dot(along, along);
  const double slack = (within_cavity - 1) * radius, depth = glm::dot(centres[0] - point, axis);
  if (depth < -slack || depth > reach + slack) return false;
  const double t = square > 0 ? std::clamp(glm::dot(d, along) / square, 0.0, 1.0) : 0;
  return glm::length(d - t * along) <= within_cavity * radius;
}

bool Cavity::holds(const Vec3& normal, const std::vector<Vec3>& corners) const {
  if (are_parallel(normal, axis) && !is_hole) return false;
  return std::all_of(corners.begin(), corners.end(), [this](const Vec3& p) { return holds(p); });
}

std::vector<Cavity> cavities_of(const PartFeatures& features, int model) {
  std::vector<Cavity> cavities;
  for (std::size_t i = 0; i < features.holes.size(); ++i) {
    const HoleFeature& hole = features.holes[i];
    if (hole.model != model) continue;
    double widest = hole.diameter;
    if (hole.counterbore) widest = hole.counterbore->diameter;
    if (hole.countersink) widest = hole.countersink->diameter;
    cavities.push_back({{hole.mouth, hole.mouth}, hole.axis, widest / 2, hole.reach, true, static_cast<int>(i)});
  }
  for (std::size_t i = 0; i < features.slots.size(); ++i)
    if (const SlotFeature& slot = features.slots[i]; slot.model == model)
      cavities.push_back({slot.centres, slot.axis, slot.radius, slot.reach, false, static_cast<int>(i)});
  return cavities;
}

std::optional<Cavity> cavity_around(const std::vector<Cavity>& cavities, const Vec3& normal,
                                    const std::vector<Vec3>& corners) {
  const auto found = std::find_if(cavities.begin(), cavities.end(),
                                  [&](const Cavity& cavity) { return cavity.holds(normal, corners); });
  if (found == cavities.end()) return std::nullopt;
  return *found;
}

}  // namespace epura::features
