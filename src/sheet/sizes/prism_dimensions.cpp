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

scene::DimensionDescription angle_of(const Planning& plan, const NamedProjection& view, const PrismGroup& group) {
  const TurnedPrism& prism = *group.front();
  const double reach = prism.widths[0] / 2;
  scene::DimensionDescription angle = plan.dimension(DimensionType::angular, view, times(group.size()) + "<>");
  angle.anchors = {prism.centre, prism.centre + reach * prism.nearest_axis(), prism.centre + reach * prism.normals[0]};
  return angle;
}

}  // namespace

bool is_over_turned_part(const Planning& plan, int axis) {
  return std::any_of(plan.table.prisms.begin(), plan.table.prisms.end(), [&](const TurnedPrism& prism) {
    return std::abs(prism.axis[axis]) <= features::parallel && prism.is_whole(plan.subject.extents) &&
           plan.views.along(prism.axis) != nullptr;
  });
}

Planned prism_dimensions(const Planning& plan) {
  Planned planned;
  const std::vector<TurnedPrism>& prisms = plan.table.prisms;
  for (const PrismGroup& group :
       groups_of<TurnedPrism>(prisms, [](const TurnedPrism&a, const TurnedPrism&b) { return are_equal(a, b); })) {
    check(group.front()->widths[0] > 0 && group.front()->widths[1] > 0, "a prism has two widths");
    const NamedProjection* view = plan.views.along(group.front()->axis);
    if (view == nullptr) continue;
    for (const std::size_t side : {0U, 1U}) planned.dimensions.push_back(width_of(plan, *view, group, side));
    planned.dimensions.push_back(angle_of(plan, *view, group));
    const int number =
        static_cast<int>(plan.table.first(SizeKind::side)) + 2 * static_cast<int>(group.front() - prisms.data());
    for (const TurnedPrism* prism : group) {
      if (!prism->is_whole(plan.subject.extents)) {
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
