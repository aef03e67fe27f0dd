// SPDX-License-Identifier: Apache-2.0
#include "sizes/cone_dimensions.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/text.hpp"
#include "features/tolerances.hpp"
#include "sizes/axis_positions.hpp"
#include "sizes/cone_angles.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::are_same;
using features::ConeFeature;
using features::CylinderFeature;
using features::same_size;
using scene::DimensionDescription;

bool are_equal_ends(const CylinderFeature& a, const CylinderFeature& b) {
  return a.model == b.model && are_same(a.radius, b.radius) && are_parallel(a.axis, b.axis);
}

Planned ends_of_cones(const Planning& plan, const std::vector<CylinderFeature>& ends) {
  Planned planned;
  for (const auto& group : groups_of<CylinderFeature>(ends, are_equal_ends)) {
    const CylinderFeature& shown = *group.front();
    const NamedProjection* view = plan.views.across(shown.axis, shown.from);
    if (view == nullptr) continue;  // an aligned section may show the other end alone
    planned.dimensions.push_back(plan.dimension(DimensionType::diameter, *view, times(group.size()) + "<>",
                                                {shown.from, shown.axis, shown.radius, {}}));
  }
  return planned;
}

// After those of sizes and spheres.
int group_of_cone(const Planning& plan, const ConeFeature& cone) {
  const features::PartFeatures& features = plan.subject.features;
  return static_cast<int>(plan.table.sizes.size() + features.balls.size()) +
         static_cast<int>(&cone - features.cones.data());
}

/// What is planned of one cone, and the ends that need a diameter.
struct PlannedCone {
  Planned angle_and_places{};
  std::vector<CylinderFeature> ends{};
};

PlannedCone dimensions_of_cone(const Planning& plan, const ConeFeature& cone, const NamedProjection& view) {
  PlannedCone planned;
  const bool horizontal = are_parallel(view.projection.u, cone.axis);
  const Vec3 out = horizontal ? -view.projection.v : view.projection.u;
  const bool by_angle = has_angle(cone, glm::length(plan.box.size()));
  if (by_angle) {
    const NamedProjection* shown = view_of_angle(cone, plan.subject.features, plan.views);
    check(shown != nullptr, "a cone that a view shows has a view of its angle");
    DimensionDescription angle = plan.dimension(DimensionType::angular, *shown, "<>");
    for (const Vec3& anchor : anchors_of_angle(cone, shown->projection)) angle.anchors.emplace_back(anchor);
    planned.angle_and_places.dimensions.push_back(std::move(angle));
  }
  for (const int end : {0, 1}) {
    if (by_angle && end == rounded_end(cone)) continue;
    const CylinderFeature circle{cone.model, cone.ends[end], cone.ends[end], cone.axis, cone.radii[end], false};
    if (!(circle.radius > 0)) continue;
    if (!is_overall(plan.subject, circle) && !features::has_coaxial_outline(plan.subject.features, circle))
      planned.ends.push_back(circle);
    if (const int axis = world_axis(cone.axis); axis >= 0)
      planned.angle_and_places.places.emplace_back(Coordinate{
          &view, axis, circle.from[axis], circle.from + circle.radius * out, -1, circle.from - circle.radius * out});
  }
  planned.angle_and_places.append(
      positions_of(plan, std::array{cone.ends[1]}, cone.axis, plan.views.along(cone.axis), group_of_cone(plan, cone)));
  return planned;
}

}  // namespace

Planned chamfer_dimensions(const Planning& plan) {
  const auto equal = [](const ConeFeature& a, const ConeFeature& b) {
    return a.model == b.model && are_same(glm::length(a.ends[1] - a.ends[0]), glm::length(b.ends[1] - b.ends[0])) &&
           are_same(a.angle, b.angle) && are_parallel(a.axis, b.axis);
  };
  Planned planned;
  for (const auto& group : groups_of<ConeFeature>(plan.subject.features.chamfers, equal)) {
    const ConeFeature& chamfer = *group.front();
    check(chamfer.angle > 0 && chamfer.angle < 90, "a chamfer is neither a cylinder nor a plane");
    const NamedProjection* view = plan.views.across(chamfer.axis, chamfer.ends[0]);
    if (view == nullptr) continue;
    const projection::Projection& projection = view->projection;
    const bool horizontal = are_parallel(projection.u, chamfer.axis);
    const Vec3 out = horizontal ? -projection.v : projection.u;
    DimensionDescription dimension = plan.dimension(DimensionType::linear, *view,
                                                    times(group.size()) + "<>×" + format_fixed(chamfer.angle, 1) + "°");
    dimension.direction = {horizontal ? DimensionDirection::horizontal : DimensionDirection::vertical,
                           plan.wanted.where};
    for (const int end : {0, 1}) dimension.anchors.emplace_back(chamfer.ends[end] + chamfer.radii[end] * out);
    planned.dimensions.push_back(std::move(dimension));
  }
  return planned;
}

Planned cone_dimensions(const Planning& plan) {
  Planned planned;
  std::vector<CylinderFeature> ends;
  for (const ConeFeature& cone : plan.subject.features.cones) {
    check(cone.radii[0] >= 0 && cone.radii[0] <= cone.radii[1], "a cone begins at its smaller end");
    const NamedProjection* view = plan.views.across(cone.axis, cone.ends[0]);
    if (view == nullptr) continue;
    PlannedCone one = dimensions_of_cone(plan, cone, *view);
    planned.append(std::move(one.angle_and_places));
    for (const CylinderFeature& end : one.ends)
      if (std::none_of(ends.begin(), ends.end(), [&](const CylinderFeature& other) {
            return are_equal_ends(other, end) && glm::distance(other.from, end.from) <= same_size * end.radius;
          }))
        ends.push_back(end);
  }
  planned.append(ends_of_cones(plan, ends));
  return planned;
}

}  // namespace epura::sheet
