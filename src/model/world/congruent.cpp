// SPDX-License-Identifier: Apache-2.0
#include "world/congruent.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace epura::world {

namespace {

/// Finds points by their position.
class PointSearch {
 public:
  explicit PointSearch(const std::vector<Vec3>& points) {
    for (const Vec3& p : points) sorted_.push_back({place(p), p});
    std::sort(sorted_.begin(), sorted_.end(), [](const Entry& a, const Entry& b) { return a.place < b.place; });
  }

  [[nodiscard]] bool has(const Vec3& p, double tolerance) const {
    const auto before = [](const Entry& entry, double value) { return entry.place < value; };
    auto at = std::lower_bound(sorted_.begin(), sorted_.end(), place(p) - tolerance, before);
    for (; at != sorted_.end() && at->place <= place(p) + tolerance; ++at)
      if (glm::length(at->point - p) <= tolerance) return true;
    return false;
  }

 private:
  struct Entry {
    double place;
    Vec3 point;
  };

  // Along a direction of length 1 in which corners of parts rarely have the same position.
  static double place(const Vec3& p) { return glm::dot(p, Vec3(0.62386, 0.31289, 0.71618)); }

  std::vector<Entry> sorted_;
};

/// Two corners that determine a position: the first of the rarest distance from the centre, the second far from the
/// line through the first.
struct Pair {
  Vec3 first, second;
};

std::optional<Pair> pair_of(const Shape& shape, double tolerance) {
  const auto count_near = [&](double reach) {
    const auto from = std::lower_bound(shape.reach.begin(), shape.reach.end(), reach - tolerance);
    return std::upper_bound(from, shape.reach.end(), reach + tolerance) - from;
  };
  const double least = 0.1 * shape.reach.back();
  Pair pair{};
  std::ptrdiff_t fewest = 0;
  for (const Vec3& p : shape.corners) {
    const double reach = glm::length(p);
    if (reach < least) continue;
    const std::ptrdiff_t count = count_near(reach);
    if (fewest != 0 && count >= fewest) continue;
    fewest = count;
    pair.first = p;
  }
  double best = 0;
  for (const Vec3& p : shape.corners) {
    const double area = glm::length(glm::cross(pair.first, p));
    if (area > best * (1 + 1e-9)) pair.second = p;
    best = std::max(best, area);
  }
  if (fewest == 0 || !(best > tolerance * glm::length(pair.first))) return std::nullopt;
  return pair;
}

// Columns: an orthonormal frame with the first corner along x and the second above it.
Mat3 frame_of(const Pair& pair) {
  const Vec3 x = glm::normalize(pair.first);
  const Vec3 z = glm::normalize(glm::cross(x, pair.second));
  return {x, glm::cross(z, x), z};
}

bool fits(const Shape& a, const Mat3& turn, const PointSearch& b, double tolerance) {
  return std::all_of(a.corners.begin(), a.corners.end(), [&](const Vec3& p) { return b.has(turn * p, tolerance); });
}

bool have_same_numbers(const Shape& a, const Shape& b, double tolerance) {
  if (a.triangles != b.triangles || a.corners.size() != b.corners.size() || a.corners.empty()) return false;
  for (std::size_t i = 0; i < a.reach.size(); ++i)
    if (std::abs(a.reach[i] - b.reach[i]) > tolerance) return false;
  const double size = a.reach.back(), slack = 10 * tolerance * size;
  return std::abs(a.area - b.area) <= slack && std::abs(std::abs(a.volume) - std::abs(b.volume)) <= slack * size;
}

}  // namespace

Shape shape_of(const World& world, const std::vector<int>& triangles) {
  Shape shape;
  shape.triangles = triangles.size();
  std::vector<int> numbers;
  Vec3 middle(0.0);
  for (const int t : triangles) {
    const std::array<int, 3>& corners = world.triangles[t];
    numbers.insert(numbers.end(), corners.begin(), corners.end());
    const Vec3 &a = world.points[corners[0]], &b = world.points[corners[1]], &c = world.points[corners[2]];
    const double area = glm::length(glm::cross(b - a, c - a)) / 2;
    shape.area += area;
    middle += area * ((a + b + c) / 3.0);
  }
  if (shape.area > 0) middle /= shape.area;
  for (const int t : triangles) {
    const std::array<int, 3>& corners = world.triangles[t];
    const Vec3 a = world.points[corners[0]] - middle, b = world.points[corners[1]] - middle;
    shape.volume += glm::dot(glm::cross(a, b), world.points[corners[2]] - middle) / 6;
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  for (const int v : numbers) {
    shape.corners.push_back(world.points[v] - middle);
    shape.reach.push_back(glm::length(shape.corners.back()));
  }
  std::sort(shape.reach.begin(), shape.reach.end());
  return shape;
}

bool are_congruent(const Shape& a, const Shape& b, double tolerance) {
  if (!have_same_numbers(a, b, tolerance)) return false;
  const auto pair = pair_of(a, tolerance);
  if (!pair) return true;  // all corners on one line
  // The direction of short pairs is less certain than their position.
  const double slack = 4 * tolerance * a.reach.back() / glm::length(pair->first);
  const double first = glm::length(pair->first), second = glm::length(pair->second);
  const double apart = glm::length(pair->second - pair->first);
  const Mat3 from = glm::transpose(frame_of(*pair));
  const PointSearch search(b.corners);
  for (const Vec3& p : b.corners) {
    if (std::abs(glm::length(p) - first) > slack) continue;
    for (const Vec3& q : b.corners)
      if (std::abs(glm::length(q) - second) <= slack && std::abs(glm::length(q - p) - apart) <= slack &&
          fits(a, frame_of({p, q}) * from, search, slack))
        return true;
  }
  return false;
}

}  // namespace epura::world
