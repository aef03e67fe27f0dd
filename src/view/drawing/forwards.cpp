// SPDX-License-Identifier: Apache-2.0
#include "drawing/forwards.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "drawing/continuations.hpp"
#include "drawing/limits.hpp"

namespace epura::drawing {

namespace {

// Whether a line turns back by 90 degrees or more at one of its points.
bool turns_back(std::span<const Vec2> points, std::size_t at) {
  return glm::dot(points[at] - points[at - 1], points[at + 1] - points[at]) < 0;
}

bool turns_back(std::span<const Vec2> points) {
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
    if (turns_back(points, i)) return true;
  return false;
}

double distance_to(std::span<const Vec2> line, const Vec2& point) {
  double least = glm::distance(line.front(), point);
  for (std::size_t i = 1; i < line.size(); ++i)
    least = std::min(least, distance_to_segment(point, line[i - 1], line[i]));
  return least;
}

// Whether points of a straight piece lie on a line within a distance; its ends do.
bool lies_on(const Vec2& from, const Vec2& to, std::span<const Vec2> line, double distance) {
  for (const double part : {0.25, 0.5, 0.75})
    if (distance_to(line, from + part * (to - from)) > distance) return false;
  return true;
}

// Whether a line that turns back at one end and forth at the other is shorter with what lies between in the opposite
// order, and has the same ink within a distance.
bool is_better_reversed(std::span<const Vec2> line, double distance) {
  const std::size_t last = line.size() - 1;
  if (!turns_back(line, 1) || !turns_back(line, last - 1)) return false;
  const double now = glm::distance(line[0], line[1]) + glm::distance(line[last - 1], line[last]);
  const double then = glm::distance(line[0], line[last - 1]) + glm::distance(line[1], line[last]);
  if (!(now - then > rounding_part * now)) return false;
  std::vector<Vec2> reversed(line.begin(), line.end());
  std::reverse(reversed.begin() + 1, reversed.end() - 1);
  return lies_on(reversed[0], reversed[1], line, distance) &&
         lies_on(reversed[last - 1], reversed[last], line, distance) && lies_on(line[0], line[1], reversed, distance) &&
         lies_on(line[last - 1], line[last], reversed, distance);
}

// Reverses pieces of a line from its start on, as long as one is better reversed.
void reverse_pieces(std::vector<Vec2>& points, double distance) {
  // Each change makes the line shorter, so that they come to an end; no line needs so many.
  std::size_t changes_left = 4 * points.size();
  for (std::size_t first = 1; first + 2 < points.size();) {
    std::size_t count = 2;
    const std::size_t most = std::min(max_reversed, points.size() - 1 - first);
    while (count <= most && !is_better_reversed(std::span(points).subspan(first - 1, count + 2), distance)) ++count;
    if (count > most || changes_left == 0) {
      ++first;
      continue;
    }
    --changes_left;
    check(first >= 1 && first + count < points.size(), "the ends of a line stay where they are");
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    std::reverse(begin, begin + static_cast<std::ptrdiff_t>(count));
    first -= std::min(first - 1, max_reversed);
  }
}

}  // namespace

std::vector<Vec2> go_forwards(std::vector<Vec2> points, bool closed, double distance) {
  if (closed) points.push_back(points.front());
  const bool is_wanted = points.size() >= 4 && turns_back(points);
  if (closed) points.pop_back();
  if (!is_wanted) return points;
  // One change may rule out another: where to begin, and which way to go, is decided by the places.
  const auto order = [](const Vec2& point) { return order_on_page(point); };
  const Vec2 start = points.front();
  const auto begin_at = [&](std::vector<Vec2>::iterator point) { std::rotate(points.begin(), point, points.end()); };
  if (closed) begin_at(std::ranges::min_element(points, {}, order));
  const bool is_backwards = order(points.back()) < order(points[closed ? 1 : 0]);
  const auto turn = [&] { std::reverse(points.begin() + (closed ? 1 : 0), points.end()); };
  if (is_backwards) turn();
  if (closed) points.push_back(points.front());
  reverse_pieces(points, distance);
  if (closed) points.pop_back();
  if (is_backwards) turn();
  if (closed) begin_at(std::find(points.begin(), points.end(), start));
  check(points.front() == start, "the first point of a line stays first");
  return points;
}

}  // namespace epura::drawing
