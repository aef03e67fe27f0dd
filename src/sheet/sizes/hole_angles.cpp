// SPDX-License-Identifier: Apache-2.0
#include "sizes/hole_angles.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "features/tolerances.hpp"
#include "sizes/equal_features.hpp"

namespace epura::sheet {

namespace {

using features::parallel;
using features::same_size;

// The direction of the hole beside that of another one.
Vec3 next_to(const Vec3& first, const HoleDirections& around) {
  const auto near = [&](const Vec3& one) { return glm::dot(one, first) > 1 - parallel ? -2.0 : glm::dot(one, first); };
  return *std::max_element(around.directions.begin(), around.directions.end(),
                           [&](const Vec3& a, const Vec3& b) { return near(a) < near(b) - parallel; });
}

}  // namespace

std::vector<scene::DimensionDescription> angles_of(const Planning& plan, const HoleDirections& around, bool with_step) {
  std::vector<scene::DimensionDescription> angles;
  const std::vector<std::size_t> needed = around.needed();
  const NamedProjection* view = plan.views.along(around.axis);
  if (view == nullptr || needed.empty()) return angles;
  const auto between = [&](const Vec3& from, const Vec3& to, const std::string& text) {
    scene::DimensionDescription& angle = angles.emplace_back(plan.dimension(DimensionType::angular, *view, text));
    angle.anchors = {around.centre, around.centre + around.reach * from, around.centre + around.reach * to};
  };
  std::vector<char> done(around.directions.size(), 0);
  for (const std::size_t i : needed) {
    check(i < done.size(), "angles are those of holes");
    if (done[i] != 0) continue;
    std::size_t count = 0;
    for (const std::size_t other : needed)
      if (around.are_alike(i, other)) {
        done[other] = 1;
        ++count;
      }
    between(around.nearest_line(around.directions[i]), around.directions[i], times(count) + "<>");
  }
  if (!with_step || !around.are_even() || around.directions.size() < 3) return angles;
  const Vec3& first = around.directions[needed.front()];
  between(first, next_to(first, around), std::to_string(around.directions.size()) + "× <>");
  return angles;
}

bool gives_direction(const AnchoredDimension& dimension, const HoleDirections& around, std::size_t number) {
  if (dimension.type != DimensionType::angular) return false;
  check(dimension.points.size() == 3, "an angle has a corner and two legs");
  const Vec3& corner = dimension.points[0];
  if (features::distance_from_line(corner, around.centre, around.axis) > 10 * same_size * around.reach) return false;
  const auto leg = [&](std::size_t end) {
    const Vec3 to = dimension.points[end] - corner, flat = to - glm::dot(to, around.axis) * around.axis;
    return glm::length(flat) > 0 ? glm::normalize(flat) : Vec3(0);
  };
  const auto is_at = [&](std::size_t end, std::size_t hole) {
    return glm::distance(leg(end), around.directions[hole]) <= 10 * same_size;
  };
  const bool many = repeats_of(dimension.text) > 1;
  for (const std::size_t end : {1U, 2U}) {
    // The step between two of them is no angle from a centre line.
    if (is_at(end, number) && (!around.are_even() || around.is_on_line(leg(3 - end)))) return true;
    for (std::size_t hole = 0; many && around.is_on_line(leg(3 - end)) && hole < around.directions.size(); ++hole)
      if (is_at(end, hole) && around.are_alike(hole, number)) return true;
  }
  return false;
}

}  // namespace epura::sheet
