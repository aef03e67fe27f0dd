// SPDX-License-Identifier: Apache-2.0
#include "triangulate.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace samples {

namespace {

// Dropping the axis closest to the normal keeps coordinates as they are: nothing is rounded again.
class Plane {
 public:
  Plane(const std::vector<Point>& points, const Point& normal) : points_(points) {
    int k = 0;
    for (int i = 1; i < 3; ++i) {
      k = std::abs(normal[i]) > std::abs(normal[k]) ? i : k;
    }
    x_ = (k + 1) % 3;
    y_ = (k + 2) % 3;
    if (normal[k] < 0) {
      std::swap(x_, y_);
    }
  }

  /// Twice the area of the triangle abc, positive when it turns left.
  double turn(int a, int b, int c) const { return (x(b) - x(a)) * (y(c) - y(a)) - (y(b) - y(a)) * (x(c) - x(a)); }
  double distance(int a, int b) const { return std::hypot(x(b) - x(a), y(b) - y(a)); }

 private:
  double x(int i) const { return points_[i][x_]; }
  double y(int i) const { return points_[i][y_]; }

  const std::vector<Point>& points_;
  int x_ = 0, y_ = 1;
};

constexpr double nothing = 1e-7;  // mm^2: well below any area here, well above what rounding leaves of a straight line

bool cross_or_touch(const Plane& plane, int a, int b, int c, int d) {
  const double abc = plane.turn(a, b, c), abd = plane.turn(a, b, d);
  const double cda = plane.turn(c, d, a), cdb = plane.turn(c, d, b);
  const auto apart = [](double s, double t) { return (s > nothing && t > nothing) || (s < -nothing && t < -nothing); };
  return !apart(abc, abd) && !apart(cda, cdb);
}

bool crosses_loop(const Plane& plane, int a, int b, const std::vector<int>& loop) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int c = loop[i], d = loop[(i + 1) % loop.size()];
    const bool shares_end = c == a || c == b || d == a || d == b;
    if (!shares_end && cross_or_touch(plane, a, b, c, d)) {
      return true;
    }
  }
  return false;
}

struct Bridge {
  std::size_t from, hole, to;  ///< place in the outline, which hole, place in the hole
  double length;
};

/// The shortest bridge between the outline and any hole. A corner carries one bridge at most: with two, one would have
/// to find out which of its copies sees the hole.
Bridge shortest_bridge(const Plane& plane, const std::vector<int>& outline,
                       const std::vector<std::vector<int>>& holes) {
  std::vector<Bridge> bridges;
  for (std::size_t h = 0; h < holes.size(); ++h) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      if (std::count(outline.begin(), outline.end(), outline[i]) > 1) {
        continue;
      }
      for (std::size_t j = 0; j < holes[h].size(); ++j) {
        bridges.push_back({i, h, j, plane.distance(outline[i], holes[h][j])});
      }
    }
  }
  std::stable_sort(bridges.begin(), bridges.end(),
                   [](const Bridge& a, const Bridge& b) { return a.length < b.length; });
  for (const Bridge& bridge : bridges) {
    const int a = outline[bridge.from], b = holes[bridge.hole][bridge.to];
    const bool blocked =
        std::any_of(holes.begin(), holes.end(), [&](const auto& hole) { return crosses_loop(plane, a, b, hole); });
    if (!blocked && !crosses_loop(plane, a, b, outline)) {
      return bridge;
    }
  }
  throw std::logic_error("a hole cannot be reached from the outline");
}

std::vector<int> join_holes(const Plane& plane, std::vector<int> outline, std::vector<std::vector<int>> holes) {
  while (!holes.empty()) {
    const Bridge bridge = shortest_bridge(plane, outline, holes);
    std::vector<int> hole = std::move(holes[bridge.hole]);
    holes.erase(holes.begin() + static_cast<std::ptrdiff_t>(bridge.hole));
    std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(bridge.to), hole.end());
    hole.push_back(hole.front());
    hole.push_back(outline[bridge.from]);
    outline.insert(outline.begin() + static_cast<std::ptrdiff_t>(bridge.from) + 1, hole.begin(), hole.end());
  }
  return outline;
}

bool is_ear(const Plane& plane, const std::vector<int>& outline, std::size_t i) {
  const std::size_t n = outline.size();
  const int a = outline[(i + n - 1) % n], b = outline[i], c = outline[(i + 1) % n];
  if (plane.turn(a, b, c) <= nothing) {
    return false;
  }
  return std::none_of(outline.begin(), outline.end(), [&](int p) {
    return p != a && p != b && p != c && plane.turn(a, b, p) >= -nothing && plane.turn(b, c, p) >= -nothing &&
           plane.turn(c, a, p) >= -nothing;
  });
}

std::size_t best_ear(const Plane& plane, const std::vector<int>& outline) {
  const std::size_t n = outline.size();
  std::vector<std::pair<double, std::size_t>> candidates;
  for (std::size_t i = 0; i < n; ++i) {
    candidates.emplace_back(plane.distance(outline[(i + n - 1) % n], outline[(i + 1) % n]), i);
  }
  std::sort(candidates.begin(), candidates.end());
  for (const auto& [length, i] : candidates) {
    if (is_ear(plane, outline, i)) {
      return i;
    }
  }
  throw std::logic_error("a face without an ear: its loops cross");
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(const std::vector<Point>& points, std::vector<int> outer,
                                            std::vector<std::vector<int>> holes, const Point& normal) {
  const Plane plane(points, normal);
  std::vector<int> outline = join_holes(plane, std::move(outer), std::move(holes));
  std::vector<std::array<int, 3>> triangles;
  while (outline.size() >= 3) {
    const std::size_t n = outline.size();
    const std::size_t i = best_ear(plane, outline);
    triangles.push_back({outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]});
    outline.erase(outline.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return triangles;
}

}  // namespace samples
