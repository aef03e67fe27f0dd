// SPDX-License-Identifier: Apache-2.0
#include "visibility/seen_from.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "visibility/limits.hpp"

namespace epura::visibility {

namespace {

// The angle from one direction to another, in -pi to pi.
double turn_between(const Vec2& from, const Vec2& to) { return std::atan2(cross(from, to), glm::dot(from, to)); }

Turn turn_from(double begin, double end, double widened) {
  begin -= widened;
  end += widened;
  check(begin <= end, "a turn is counterclockwise");
  if (!(end - begin < 2 * std::numbers::pi)) return all_around;
  if (begin < -std::numbers::pi) return {begin + 2 * std::numbers::pi, end + 2 * std::numbers::pi};
  if (begin > std::numbers::pi) return {begin - 2 * std::numbers::pi, end - 2 * std::numbers::pi};
  return {begin, end};
}

// The interval of directions that all lie on one side of the place.
template <std::size_t count>
Turn turn_over(const std::array<Vec2, count>& ways, double widened) {
  double min = 0, max = 0;
  for (const Vec2& way : ways) {
    const double turn = turn_between(ways.front(), way);
    min = std::min(min, turn);
    max = std::max(max, turn);
  }
  if (!(max - min < std::numbers::pi)) return all_around;
  const double first = std::atan2(ways.front().y, ways.front().x);
  return turn_from(first + min, first + max, widened);
}

double distance_to(const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0 ? std::clamp(-glm::dot(a, along) / length2, 0.0, 1.0) : 0;
  return glm::length(a + t * along);
}

// The angle by which rounding may turn something `distance` cells away; half a circle or more where it may lie in any
// direction.
double turned_by_rounding(double distance) {
  return distance > behind_cells ? turn_rounding + std::asin(behind_cells / distance) : 2 * std::numbers::pi;
}

}  // namespace

SeenFrom::SeenFrom(const view::ProjectedScene& view, const view::GridPoint& place) : place_(place), cell_(view.cell) {}

Vec2 SeenFrom::way_to(const view::GridPoint& point) const {
  return {static_cast<double>(std::int64_t{point.x} - place_.x), static_cast<double>(std::int64_t{point.y} - place_.y)};
}

Turn SeenFrom::of_triangle(const view::ProjectedScene& view, const view::ViewTriangle& triangle) const {
  std::array<view::GridPoint, 3> corners{};
  for (std::size_t i = 0; i < 3; ++i) corners[i] = view.grid[triangle.vertex[i]];
  for (std::size_t i = 0; i < 3; ++i)
    if (is_at(corners[i]))
      return turn_over(std::array{way_to(corners[(i + 1) % 3]), way_to(corners[(i + 2) % 3])}, turn_rounding);
  const std::array ways{way_to(corners[0]), way_to(corners[1]), way_to(corners[2])};
  const double distance =
      std::min({distance_to(ways[0], ways[1]), distance_to(ways[1], ways[2]), distance_to(ways[2], ways[0])});
  return turn_over(ways, turned_by_rounding(distance));
}

Turn SeenFrom::of_edge(const view::ProjectedScene& view, const PageEdge& edge) const {
  const Vec2 way = way_to(view.grid[is_at(view.grid[edge.p]) ? edge.q : edge.p]);
  return turn_over(std::array{way}, turn_rounding);
}

Turn SeenFrom::of_line(const Vec2& a, const Vec2& b) const {
  const Vec2 place(place_.x, place_.y);
  const Vec2 from = a / cell_ - place, to = b / cell_ - place;
  return turn_over(std::array{from, to}, turned_by_rounding(distance_to(from, to)));
}

}  // namespace epura::visibility
