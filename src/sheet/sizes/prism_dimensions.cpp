// SPDX-License-Identifier: Apache-2.0
#include "sizes/prism_dimensions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

namespace {

using PrismGroup = std::vector<const TurnedPrism*>;

// From one side to the other, along the end of both.
scene::DimensionDescription width_of(const Planning& plan, const NamedProjection& view, const PrismGroup& group,
                                     std::size_t side) {
  const TurnedPrism& prism = *group.front();
  const Vec3 half = prism.widths[side] / 2 * prism.normals[side];
  const Vec3 end = prism.centre + prism.widths[1 - side] / 2 * prism.normals[1 - side];
  scene::DimensionDescription width = plan.dimension(DimensionType::aligned, view, times(group.size()) + "<>");
  width.anchors = {end - half, end + half};
  return width;
}

// Those of a prism, either way.
std::vector<Side> sides_of(const TurnedPrism& prism) {
  std::vector<Side> sides;
  for (const std::size_t side : {0U, 1U})
    for (const double way : {-1.0, 1.0})
      for (const double other : {-0.5, 0.5}) {
        const Vec3 along = way * prism.widths[side] * prism.normals[side];
        const Vec3 middle = prism.centre + other * prism.widths[1 - side] * prism.normals[1 - side];
        sides.push_back({middle - along / 2.0, along});
      }
  return sides;
}

}  // namespace

scene::DimensionDescription angle_to_axis(const Planning& plan, const NamedProjection& view,
                                          const std::vector<Side>& sides, const std::string& text) {
  constexpr double drawn = 1.0 / 16;  // of a side, which an extension line prolongs
  const Vec3 &sight = view.projection.n, &up = view.projection.v;
  const Side* best = nullptr;
  Vec3 axis(0);
  double least = HUGE_VAL;
  for (const Side& side : sides)
    for (int world = 0; world < 3; ++world) {
      const Vec3 one = (side.along[world] < 0 ? -1.0 : 1.0) * Mat3(1)[world];
      const double off = glm::length(glm::cross(one, glm::normalize(side.along)));
      const bool is_lower = best == nullptr || glm::dot(side.corner - best->corner, up) < 0;
      if (std::abs(glm::dot(one, sight)) > features::parallel || off > least + features::parallel ||
          (off > least - features::parallel && !is_lower))
        continue;
      best = &side;
      axis = one;
      least = off;
    }
  check(best != nullptr, "a view has two axes across it, and an angle a side");
  scene::DimensionDescription angle = plan.dimension(DimensionType::angular, view, text);
  angle.anchors = {best->corner, best->corner + drawn * glm::length(best->along) * axis, best->corner + best->along};
  return angle;
}

bool is_over_turned_part(const Planning& plan, int axis) {
  return plan.table.turns(axis) && plan.views.along(plan.table.turned->axis) != nullptr;
}

Planned prism_dimensions(const Planning& plan) {
  Planned planned;
  const std::vector<TurnedPrism>& prisms = plan.table.prisms;
  const auto is_whole = [&](const TurnedPrism& one) {
    return plan.table.turned && is_ended_by(*plan.table.turned, one);
  };
  std::vector<PrismGroup> groups =
      groups_of<TurnedPrism>(prisms, [](const TurnedPrism& a, const TurnedPrism& b) { return are_equal(a, b); });
  std::stable_partition(groups.begin(), groups.end(),
                        [&](const PrismGroup& group) { return is_whole(*group.front()); });
  std::vector<const TurnedPrism*> with_angle;
  for (const PrismGroup& group : groups) {
    check(group.front()->widths[0] > 0 && group.front()->widths[1] > 0, "a prism has two widths");
    const NamedProjection* view = plan.views.along(group.front()->axis);
    if (view == nullptr) continue;
    for (const std::size_t side : {0U, 1U}) planned.dimensions.push_back(width_of(plan, *view, group, side));
    if (std::ranges::none_of(with_angle,
                             [&](const TurnedPrism* one) { return plan.table.share_angle(*one, *group.front()); })) {
      planned.dimensions.push_back(angle_to_axis(plan, *view, sides_of(*group.front()), times(group.size()) + "<>"));
      with_angle.push_back(group.front());
    }
    const int number =
        static_cast<int>(plan.table.first(SizeKind::side)) + 2 * static_cast<int>(group.front() - prisms.data());
    for (const TurnedPrism* prism : group) {
      if (!is_whole(*prism)) {
        planned.append(positions_of(plan, std::array{prism->centre}, prism->axis, view, number));
        continue;
      }
      for (int axis = 0; axis < 3; ++axis)
        if (std::abs(prism->axis[axis]) <= features::parallel)
          planned.places.emplace_back(KnownPlace{axis, prism->centre[axis]});
    }
  }
  return planned;
}

}  // namespace epura::sheet
