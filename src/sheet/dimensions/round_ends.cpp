// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/round_ends.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "design/tolerances.hpp"

namespace epura::sheet {

namespace {

constexpr double slack_degrees = 0.5;  // of the ends of an arc, which are vertices of its facets

double degrees_between(const Vec3& a, const Vec3& b) {
  return portable_atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

bool is_half_turn(double half) { return half >= 90 - slack_degrees; }

bool has_hole(const design::DesignFeatures& features, const RoundEnd& end) {
  const auto is_around = [&end](const Vec3& point, const Vec3& axis) {
    return design::are_parallel(axis, end.axis) &&
           glm::length(glm::cross(point - end.centre, end.axis)) <= 10 * design::same_size * end.radius;
  };
  return std::any_of(features.holes.begin(), features.holes.end(),
                     [&](const design::DesignHole& hole) { return is_around(hole.mouth, hole.axis); }) ||
         std::any_of(features.cylinders.begin(), features.cylinders.end(),
                     [&](const design::DesignCylinder& one) { return one.inwards && is_around(one.from, one.axis); });
}

}  // namespace

bool RoundEnd::bulges(int along, int side) const {
  return degrees_between(middle, (side == 0 ? -1.0 : 1.0) * Mat3(1)[along]) <= half - slack_degrees;
}

bool RoundEnd::ends_models(int along, int side, const design::Extent& extent) const {
  check(along >= 0 && along < 3 && (side == 0 || side == 1), "the models have two ends along each axis");
  if (extent.form != design::ExtentForm::length || std::abs(axis[along]) > design::parallel) return false;
  const double way = side == 0 ? -1 : 1, end = side == 0 ? extent.from : extent.to;
  if (std::abs(centre[along] + way * radius - end) > 10 * design::same_size * radius) return false;
  // A rounded corner of the part ends where it touches the faces beside it.
  return bulges(along, side) ||
         (is_half_turn(half) && degrees_between(middle, way * Mat3(1)[along]) <= half + slack_degrees);
}

std::vector<RoundEnd> find_round_ends(const design::DesignFeatures& features) {
  std::vector<RoundEnd> ends;
  for (const design::DesignArc& arc : features.arcs) {
    if (arc.inwards) continue;
    check(arc.points.size() == 9, "an arc has its ends and its middle");
    const Vec3 middle = (arc.points[4] - arc.centre) / arc.radius;
    const RoundEnd end{arc.centre, arc.axis, arc.radius, middle,
                       degrees_between(middle, (arc.points[0] - arc.centre) / arc.radius)};
    if (is_half_turn(end.half) || has_hole(features, end)) ends.push_back(end);
  }
  return ends;
}

const RoundEnd* end_along(std::span<const RoundEnd> ends, int axis, int side, const design::Extent& extent) {
  for (const RoundEnd& end : ends)
    if (end.ends_models(axis, side, extent)) return &end;
  return nullptr;
}

}  // namespace epura::sheet
