// SPDX-License-Identifier: Apache-2.0
#include "sizes/hole_directions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "base/portable_math.hpp"
#include "features/tolerances.hpp"

namespace epura::sheet {

namespace {

using features::are_parallel;
using features::HoleFeature;
using features::parallel;
using features::same_size;

bool are_equal_apart_from_axes(const HoleFeature& a, const HoleFeature& b) {
  HoleFeature turned = b;
  turned.axis = a.axis;
  return features::are_equal(a, turned);
}

double lean(const HoleFeature& hole, const features::CylinderFeature& cylinder) {
  return std::abs(glm::dot(hole.axis, cylinder.axis));
}

// Whether the axis of a hole meets that of a cylinder.
bool is_radial_to(const HoleFeature& hole, const features::CylinderFeature& cylinder) {
  if (hole.model != cylinder.model || are_parallel(hole.axis, cylinder.axis)) return false;
  const Vec3 normal = glm::normalize(glm::cross(hole.axis, cylinder.axis));
  return std::abs(glm::dot(cylinder.from - hole.mouth, normal)) <= 10 * same_size * cylinder.radius;
}

// Where it does.
Vec3 meeting_of(const HoleFeature& hole, const features::CylinderFeature& cylinder) {
  const Vec3 flat = hole.axis - glm::dot(hole.axis, cylinder.axis) * cylinder.axis;
  const double along = glm::dot(cylinder.from - hole.mouth, flat) / glm::dot(flat, flat);
  const Vec3 at = hole.mouth + along * hole.axis;
  return cylinder.from + glm::dot(at - cylinder.from, cylinder.axis) * cylinder.axis;
}

// Equal holes about a cylinder at one height, or, if these are parallel to each other and to no axis of the world, at
// all heights; none for others.
std::vector<const HoleFeature*> holes_about(const features::CylinderFeature& cylinder,
                                            const std::vector<const HoleFeature*>& candidates) {
  const HoleFeature& first = *candidates.front();
  std::vector<const HoleFeature*> level, parallels;
  for (const HoleFeature* other : candidates) {
    if (!is_radial_to(*other, cylinder) || !are_equal_apart_from_axes(first, *other) ||
        std::abs(lean(*other, cylinder) - lean(first, cylinder)) > parallel)
      continue;
    if (glm::distance(meeting_of(*other, cylinder), meeting_of(first, cylinder)) <= 10 * same_size * cylinder.radius)
      level.push_back(other);
    if (are_parallel(other->axis, first.axis)) parallels.push_back(other);
  }
  const auto is_turned = [&](const HoleFeature* hole) { return !are_parallel(hole->axis, first.axis); };
  check(!level.empty(), "a hole is on a level with itself");
  if (lean(first, cylinder) > parallel)
    return level.size() >= features::fewest_holes ? level : std::vector<const HoleFeature*>{};
  if (std::any_of(level.begin(), level.end(), is_turned)) return level;
  const bool is_askew = features::axis_along(first.axis) < 0 && features::axis_along(cylinder.axis) >= 0;
  return is_askew ? parallels : std::vector<const HoleFeature*>{};
}

std::optional<std::array<Vec3, 2>> cross_of(const Vec3& axis) {
  std::vector<Vec3> across;
  for (int world = 0; world < 3; ++world)
    if (std::abs(axis[world]) <= parallel) across.push_back(Mat3(1)[world]);
  if (const std::optional<Vec3> slanted = slanted_across(axis)) across.push_back(*slanted);
  if (across.size() != 2) return std::nullopt;
  return std::array{across[0], across[1]};
}

// Whether a hole, or the middle between two neighbours, is on a centre line.
bool has_line(const HoleDirections& even) {
  const Vec3& first = even.directions.front();
  const double half = std::numbers::pi / static_cast<double>(even.directions.size());
  const Vec3 middle = portable_cos(half) * first + portable_sin(half) * glm::cross(even.axis, first);
  const auto can_be_on_line = [&](const Vec3& one) {
    for (std::size_t step = 0; step < even.directions.size(); ++step) {
      const double turn = 2 * half * static_cast<double>(step);
      if (even.is_on_line(portable_cos(turn) * one + portable_sin(turn) * glm::cross(even.axis, one))) return true;
    }
    return false;
  };
  return can_be_on_line(first) || can_be_on_line(middle);
}

}  // namespace

std::optional<Vec3> slanted_across(const Vec3& axis) {
  if (features::axis_along(axis) >= 0) return std::nullopt;
  for (int world = 0; world < 3; ++world)
    if (std::abs(axis[world]) <= parallel) return glm::normalize(glm::cross(Mat3(1)[world], axis));
  return std::nullopt;
}

std::vector<RadialPattern> find_radial_patterns(const features::PartFeatures& features) {
  std::vector<RadialPattern> patterns;
  std::vector<char> taken(features.holes.size(), 0);
  for (const features::CylinderFeature& cylinder : features.cylinders)
    for (std::size_t first = 0; first < features.holes.size(); ++first) {
      const HoleFeature& hole = features.holes[first];
      if (taken[first] != 0 || !is_radial_to(hole, cylinder)) continue;
      std::vector<const HoleFeature*> left;
      for (std::size_t i = first; i < features.holes.size(); ++i)
        if (taken[i] == 0) left.push_back(&features.holes[i]);
      const std::vector<const HoleFeature*> holes = holes_about(cylinder, left);
      if (holes.empty()) continue;
      check(holes.front() == &hole, "a radial pattern begins with the first of its holes");
      patterns.push_back({meeting_of(hole, cylinder), cylinder.axis, holes, lean(hole, cylinder) > parallel});
      for (const HoleFeature* one : holes) taken[static_cast<std::size_t>(one - features.holes.data())] = 1;
    }
  return patterns;
}

std::array<Vec3, 2> RadialPattern::legs(const HoleFeature& hole) const {
  const Vec3 begin = hole.mouth - centre, end = begin - hole.reach * hole.axis;
  const Vec3& leg = glm::length(begin) < glm::length(end) ? end : begin;
  check(is_slanted, "a hole square to an axis needs no angle to it");
  return {glm::dot(leg, axis) * axis, leg};
}

Vec3 HoleDirections::nearest_line(const Vec3& direction) const {
  check(cross.has_value(), "angles are measured from centre lines");
  Vec3 nearest(0);
  for (const Vec3& line : *cross) {
    const Vec3 one = glm::dot(line, direction) < 0 ? -line : line;
    if (glm::dot(one, direction) > glm::dot(nearest, direction) + parallel) nearest = one;
  }
  return nearest;
}

// As exactly as holes are even: the cosine of 10 same_size.
bool HoleDirections::is_on_line(const Vec3& direction) const {
  return cross && std::any_of(cross->begin(), cross->end(), [&](const Vec3& line) {
           return std::abs(glm::dot(line, direction)) >= 1 - 50 * same_size * same_size;
         });
}

bool HoleDirections::are_even() const {
  if (directions.size() < 2 || !cross) return false;
  std::vector<double> angles;
  for (const Vec3& direction : directions)
    angles.push_back(portable_atan2(glm::dot(direction, (*cross)[1]), glm::dot(direction, (*cross)[0])));
  std::sort(angles.begin(), angles.end());
  const double turn = 2 * std::numbers::pi, step = turn / static_cast<double>(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles.front() + turn;
    if (std::abs(next - angles[i] - step) > 10 * same_size) return false;
  }
  return true;
}

std::vector<std::size_t> HoleDirections::needed() const {
  if (!cross || (are_even() && has_line(*this))) return {};
  std::vector<std::size_t> askew;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto is_there = [&](std::size_t j) { return glm::distance(directions[i], directions[j]) <= 10 * same_size; };
    if (!is_on_line(directions[i]) && std::none_of(askew.begin(), askew.end(), is_there)) askew.push_back(i);
  }
  if (!are_even()) return askew;
  const auto off = [&](std::size_t i) { return 1 - glm::dot(nearest_line(directions[i]), directions[i]); };
  return {*std::min_element(askew.begin(), askew.end(),
                            [&](std::size_t a, std::size_t b) { return off(a) < off(b) - parallel; })};
}

bool HoleDirections::are_alike(std::size_t a, std::size_t b) const {
  const auto angle = [this](std::size_t i) {
    const Vec3 near = nearest_line(directions[i]);
    return portable_atan2(glm::length(glm::cross(near, directions[i])), glm::dot(near, directions[i]));
  };
  return std::abs(angle(a) - angle(b)) <= 10 * same_size;
}

HoleDirections directions_of(const RadialPattern& pattern, const OwnDirections& own) {
  HoleDirections around{pattern.centre, pattern.axis, pattern.holes, {}, 0, own ? own : cross_of(pattern.axis)};
  for (const HoleFeature* hole : pattern.holes) {
    const Vec3 to = hole->mouth - around.centre, flat = to - glm::dot(to, pattern.axis) * pattern.axis;
    around.reach = std::max(around.reach, glm::length(flat));
    around.directions.push_back(glm::length(flat) > hole->diameter * same_size ? glm::normalize(flat) : hole->axis);
  }
  return around;
}

HoleDirections directions_of(const features::PartFeatures& features, int number, const OwnDirections& own) {
  const features::PitchCircleFeature& circle = features.pitch_circles[static_cast<std::size_t>(number)];
  HoleDirections around{circle.centre, circle.axis, {}, {}, circle.radius, own ? own : cross_of(circle.axis)};
  for (const HoleFeature& hole : features.holes)
    if (hole.pitch_circle == number) {
      const Vec3 to = hole.mouth - circle.centre;
      around.holes.push_back(&hole);
      around.directions.push_back(glm::normalize(to - glm::dot(to, circle.axis) * circle.axis));
    }
  return around;
}

}  // namespace epura::sheet
