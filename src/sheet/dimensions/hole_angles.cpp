// SPDX-License-Identifier: Apache-2.0
#include "sheet/dimensions/hole_angles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "base/text.hpp"
#include "design/tolerances.hpp"
#include "sheet/dimensions/equal_features.hpp"

namespace epura::sheet {

namespace {

using design::are_parallel;
using design::DesignHole;
using design::parallel;
using design::same_size;

double distance_from_line(const Vec3& point, const Vec3& on_line, const Vec3& axis) {
  return glm::length(glm::cross(point - on_line, axis));
}

bool are_equal_apart_from_axes(const DesignHole& a, const DesignHole& b) {
  DesignHole turned = b;
  turned.axis = a.axis;
  return design::are_equal(a, turned);
}

// Whether the axis of a hole meets that of a cylinder, perpendicular to it.
bool is_radial(const DesignHole& hole, const design::DesignCylinder& cylinder) {
  if (hole.model != cylinder.model || std::abs(glm::dot(hole.axis, cylinder.axis)) > parallel) return false;
  const Vec3 normal = glm::cross(hole.axis, cylinder.axis);
  return std::abs(glm::dot(cylinder.from - hole.mouth, normal)) <= 10 * same_size * cylinder.radius;
}

// Radians about the axis of the world, from the next one.
double angle_of(const Vec3& direction, const Vec3& axis) {
  const int along = design::axis_along(axis);
  check(along >= 0, "angles are about an axis of the world");
  return portable_atan2(direction[(along + 2) % 3], direction[(along + 1) % 3]);
}

// The axis of the world across `axis` that is nearest to a direction.
Vec3 nearest_axis(const Vec3& direction, const Vec3& axis) {
  Vec3 nearest(0);
  for (int world = 0; world < 3; ++world) {
    if (std::abs(axis[world]) > parallel) continue;
    const Vec3 one = (direction[world] < 0 ? -1.0 : 1.0) * Mat3(1)[world];
    if (glm::dot(one, direction) > glm::dot(nearest, direction) + parallel) nearest = one;
  }
  return nearest;
}

// As exactly as holes are even: the cosine of 10 same_size.
bool is_on_axis(const Vec3& direction) {
  return std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)}) >=
         1 - 50 * same_size * same_size;
}

// Whether a hole, or the middle between two neighbours, is on an axis of the world: centre lines show that.
bool has_axis(const HoleDirections& even) {
  const Vec3& first = even.directions.front();
  const double half = std::numbers::pi / static_cast<double>(even.directions.size());
  const Vec3 middle = portable_cos(half) * first + portable_sin(half) * glm::cross(even.axis, first);
  const auto can_be_on_axis = [&](const Vec3& one) {
    for (std::size_t step = 0; step < even.directions.size(); ++step) {
      const double turn = 2 * half * static_cast<double>(step);
      if (is_on_axis(portable_cos(turn) * one + portable_sin(turn) * glm::cross(even.axis, one))) return true;
    }
    return false;
  };
  return can_be_on_axis(first) || can_be_on_axis(middle);
}

}  // namespace

std::vector<RadialPattern> find_radial_patterns(const design::DesignFeatures& features) {
  std::vector<RadialPattern> patterns;
  std::vector<char> taken(features.holes.size(), 0);
  for (const design::DesignCylinder& cylinder : features.cylinders)
    for (std::size_t first = 0; first < features.holes.size(); ++first) {
      const DesignHole& hole = features.holes[first];
      if (taken[first] != 0 || !is_radial(hole, cylinder)) continue;
      std::vector<std::size_t> equal;
      for (std::size_t i = first; i < features.holes.size(); ++i)
        if (const DesignHole& other = features.holes[i];
            taken[i] == 0 && is_radial(other, cylinder) && are_equal_apart_from_axes(hole, other) &&
            std::abs(glm::dot(other.mouth - hole.mouth, cylinder.axis)) <= 10 * same_size * cylinder.radius)
          equal.push_back(i);
      const auto is_turned = [&](std::size_t i) { return !are_parallel(features.holes[i].axis, hole.axis); };
      if (std::none_of(equal.begin(), equal.end(), is_turned)) continue;
      check(equal.size() >= 2, "of several directions, there are several holes");
      RadialPattern& pattern = patterns.emplace_back();
      pattern.axis = cylinder.axis;
      for (const std::size_t i : equal) {
        pattern.holes.push_back(&features.holes[i]);
        taken[i] = 1;
      }
    }
  return patterns;
}

bool HoleDirections::are_even() const {
  if (directions.size() < 2 || design::axis_along(axis) < 0) return false;
  std::vector<double> angles;
  for (const Vec3& direction : directions) angles.push_back(angle_of(direction, axis));
  std::sort(angles.begin(), angles.end());
  const double turn = 2 * std::numbers::pi, step = turn / static_cast<double>(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + turn;
    if (std::abs(next - angles[i] - step) > 10 * same_size) return false;
  }
  return true;
}

std::vector<std::size_t> HoleDirections::needed() const {
  if (design::axis_along(axis) < 0 || (are_even() && has_axis(*this))) return {};
  std::vector<std::size_t> askew;
  for (std::size_t i = 0; i < directions.size(); ++i)
    if (!is_on_axis(directions[i])) askew.push_back(i);
  if (!are_even()) return askew;
  const auto off = [&](std::size_t i) { return 1 - glm::dot(nearest_axis(directions[i], axis), directions[i]); };
  return {*std::min_element(askew.begin(), askew.end(),
                            [&](std::size_t a, std::size_t b) { return off(a) < off(b) - parallel; })};
}

bool HoleDirections::are_alike(std::size_t a, std::size_t b) const {
  const auto angle = [this](std::size_t i) {
    const Vec3 near = nearest_axis(directions[i], axis);
    return portable_atan2(glm::length(glm::cross(near, directions[i])), glm::dot(near, directions[i]));
  };
  return std::abs(angle(a) - angle(b)) <= 10 * same_size;
}

HoleDirections directions_of(const RadialPattern& pattern) {
  const DesignHole& first = *pattern.holes.front();
  const Vec3 off = first.mouth;
  // The axis of the part meets that of each hole: the point of the first one that is nearest to the second turned one.
  const auto turned = std::find_if(pattern.holes.begin(), pattern.holes.end(),
                                   [&](const DesignHole* hole) { return !are_parallel(hole->axis, first.axis); });
  check(turned != pattern.holes.end(), "holes of a radial pattern have several directions");
  const Vec3 normal = glm::cross(pattern.axis, (*turned)->axis);
  const double t = glm::dot((*turned)->mouth - off, normal) / glm::dot(first.axis, normal);
  HoleDirections around{off + t * first.axis, pattern.axis, pattern.holes, {}, 0};
  for (const DesignHole* hole : pattern.holes) {
    const Vec3 to = hole->mouth - around.centre, flat = to - glm::dot(to, pattern.axis) * pattern.axis;
    around.reach = std::max(around.reach, glm::length(flat));
    around.directions.push_back(glm::length(flat) > hole->diameter * same_size ? glm::normalize(flat) : hole->axis);
  }
  return around;
}

HoleDirections directions_of(const design::DesignFeatures& features, int number) {
  const design::DesignPitchCircle& circle = features.pitch_circles[static_cast<std::size_t>(number)];
  HoleDirections around{circle.centre, circle.axis, {}, {}, circle.radius};
  for (const DesignHole& hole : features.holes)
    if (hole.pitch_circle == number) {
      const Vec3 to = hole.mouth - circle.centre;
      around.holes.push_back(&hole);
      around.directions.push_back(glm::normalize(to - glm::dot(to, circle.axis) * circle.axis));
    }
  return around;
}

void add_angles(Planning& plan, const HoleDirections& around, bool with_step) {
  const std::vector<std::size_t> needed = around.needed();
  const NamedProjection* view = plan.views.along(around.axis);
  if (view == nullptr || needed.empty()) return;
  const auto between = [&](const Vec3& from, const Vec3& to, const std::string& text) {
    plan.add(DimensionType::angular, *view, text).anchors = {around.centre, around.centre + around.reach * from,
                                                             around.centre + around.reach * to};
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
    between(nearest_axis(around.directions[i], around.axis), around.directions[i], times(count) + "<>");
  }
  if (!with_step || !around.are_even() || around.directions.size() < 3) return;
  const Vec3& first = around.directions[needed.front()];
  const auto next =
      std::max_element(around.directions.begin(), around.directions.end(), [&](const Vec3& a, const Vec3& b) {
        const auto near = [&](const Vec3& one) {
          return glm::dot(one, first) > 1 - parallel ? -2.0 : glm::dot(one, first);
        };
        return near(a) < near(b) - parallel;
      });
  between(first, *next, std::to_string(around.directions.size()) + "× <>");
}

bool gives_direction(const AnchoredDimension& dimension, const HoleDirections& around, std::size_t number) {
  if (dimension.type != DimensionType::angular) return false;
  check(dimension.points.size() == 3, "an angle has a corner and two legs");
  const Vec3& corner = dimension.points[0];
  if (distance_from_line(corner, around.centre, around.axis) > 10 * same_size * around.reach) return false;
  const auto leg = [&](std::size_t end) {
    const Vec3 to = dimension.points[end] - corner, flat = to - glm::dot(to, around.axis) * around.axis;
    return glm::length(flat) > 0 ? glm::normalize(flat) : Vec3(0);
  };
  const auto is_at = [&](std::size_t end, std::size_t hole) {
    return glm::distance(leg(end), around.directions[hole]) <= 10 * same_size;
  };
  const bool many = repeats_of(dimension.text) > 1;
  for (const std::size_t end : {1U, 2U}) {
    // The step between two of them is no angle from an axis.
    if (is_at(end, number) && (!around.are_even() || is_on_axis(leg(3 - end)))) return true;
    for (std::size_t hole = 0; many && is_on_axis(leg(3 - end)) && hole < around.directions.size(); ++hole)
      if (is_at(end, hole) && around.are_alike(hole, number)) return true;
  }
  return false;
}

}  // namespace epura::sheet
