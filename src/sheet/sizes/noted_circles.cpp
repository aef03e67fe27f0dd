// SPDX-License-Identifier: Apache-2.0
#include "sizes/noted_circles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "definition/limits.hpp"
#include "features/tolerances.hpp"
#include "surfaces/least_squares.hpp"

namespace epura::sheet {

namespace {

// The centres of circles of a radius through two points.
std::vector<Vec2> centres_of(const Vec2& a, const Vec2& b, double radius, double slack) {
  const Vec2 middle = (a + b) / 2.0, half = (b - a) / 2.0;
  const double length = glm::length(half);
  if (!(length > 0) || length > radius + slack) return {};
  const double rise = std::sqrt(std::max(0.0, radius * radius - length * length));
  const Vec2 across = Vec2(-half.y, half.x) * (rise / length);
  return {middle + across, middle - across};
}

std::optional<Vec2> centre_through(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 ab = b - a, ac = c - a;
  const double twice = 2 * cross(ab, ac);
  if (std::abs(twice) <= features::parallel * glm::length(ab) * glm::length(ac)) return std::nullopt;
  const double square = glm::dot(ab, ab), other = glm::dot(ac, ac);
  return a + Vec2(ac.y * square - ab.y * other, ab.x * other - ac.x * square) / twice;
}

// `across`: two directions across the axis of a hole, in which the centre and the places are given.
CircleOfHoles circle_about(const Vec2& centre, double radius, const std::vector<Vec2>& places, double slack,
                           const WorldCircle& hole, const std::array<Vec3, 2>& across) {
  const Vec3 middle = centre.x * across[0] + centre.y * across[1] + glm::dot(hole.centre, hole.axis) * hole.axis;
  CircleOfHoles found{{middle, hole.axis, radius, {}, true}, {}};
  for (const Vec2& place : places)
    if (std::abs(glm::distance(place, centre) - radius) <= slack)
      found.angles.push_back(std::atan2(place.y - centre.y, place.x - centre.x));
  std::sort(found.angles.begin(), found.angles.end());
  return found;
}

}  // namespace

bool CircleOfHoles::is_even() const {
  const double step = full_turn / static_cast<double>(angles.size());
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const double next = i + 1 < angles.size() ? angles[i + 1] : angles[0] + full_turn;
    if (std::abs(next - angles[i] - step) > definition::drawn_parallel * 10) return false;
  }
  return angles.size() > 1;
}

std::vector<CircleOfHoles> circles_of_holes(const WorldCircle& hole, const std::vector<WorldCircle>& equal,
                                            std::optional<double> diameter, double slack) {
  constexpr std::size_t most = 200;  // pairs of which are compared with all
  const auto [u, v] = surfaces::square_to(hole.axis);
  const Vec2 own(glm::dot(hole.centre, u), glm::dot(hole.centre, v));
  std::vector<Vec2> places{own};
  for (const WorldCircle& one : equal) {
    const Vec2 place(glm::dot(one.centre, u), glm::dot(one.centre, v));
    const auto is_there = [&](const Vec2& other) { return glm::distance(other, place) <= slack; };
    if (features::are_parallel(one.axis, hole.axis) && std::ranges::none_of(places, is_there)) places.push_back(place);
  }
  check(places.front() == own, "a hole is on each of its circles");
  if (places.size() > most) places.resize(most);
  std::vector<CircleOfHoles> found;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (diameter)
      for (const Vec2& centre : centres_of(own, places[i], *diameter / 2, slack))
        found.push_back(circle_about(centre, *diameter / 2, places, slack, hole, {u, v}));
    for (std::size_t j = 1; j < i && !diameter; ++j)
      if (const auto centre = centre_through(own, places[i], places[j]))
        found.push_back(circle_about(*centre, glm::distance(own, *centre), places, slack, hole, {u, v}));
  }
  return found;
}

}  // namespace epura::sheet
