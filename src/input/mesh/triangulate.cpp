// SPDX-License-Identifier: Apache-2.0
// Ear clipping [Meisters. Polygons Have Ears. Amer. Math. Monthly 1975] for polygons that may touch themselves, such as
// those whose holes are connected to the outline by a bridge. Each cut subtracts the signed area of its triangle from
// that of the polygon, so the total is preserved whatever is cut.
#include "mesh/triangulate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "base/vec.hpp"
#include "mesh/simple_rings.hpp"
#include "search/bounds_tree.hpp"
#include "search/halved_order.hpp"

namespace epura::mesh {

namespace {

constexpr std::size_t faces_a_look = 256;

double area(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// The ring's corners projected to the coordinate plane in which its area is largest, oriented so that the area is
/// positive.
std::vector<Vec2> flattened(std::span<const int> ring, const Points& points) {
  double largest = 0;
  for (const int corner : ring)
    for (const double x : points[corner]) largest = std::max(largest, std::abs(x));
  // A power of two scales without rounding, and keeps products of very large or small coordinates in range.
  const double scale = largest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1.0;
  std::vector<Vec3> places;
  for (const int c : ring) places.push_back(Vec3(points[c][0], points[c][1], points[c][2]) * scale);

  Vec3 normal{};
  for (std::size_t i = 1; i + 1 < places.size(); ++i)
    normal += glm::cross(places[i] - places[0], places[i + 1] - places[0]);
  const Vec3 size = glm::abs(normal);
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<Vec2> flat;
  for (const Vec3& p : places) flat.push_back(normal[axis] < 0 ? Vec2(p[v], p[u]) : Vec2(p[u], p[v]));
  return flat;
}

/// Whether the polygon is a fan: all other corners are visible from the first one, within less than half a turn.
bool is_fan(const std::vector<Vec2>& p) {
  for (std::size_t i = 2; i < p.size(); ++i)
    if (!(area(p[0], p[1], p[i]) > 0 && area(p[0], p[i - 1], p[i]) > 0)) return false;
  return true;
}

/// The remaining corners of a polygon, halved again and again across the longer side of their box: corners may lie
/// close together anywhere.
class CornerTree {
 public:
  explicit CornerTree(const std::vector<Vec2>& places) : p_(places), is_left_(places.size(), 1), left_(places.size()) {
    members_.resize(places.size());
    std::iota(members_.begin(), members_.end(), 0);
    build();
  }

  /// Builds the tree anew once half of its corners are gone.
  void remove(int corner) {
    is_left_[corner] = 0;
    if (--left_ > members_.size() / 2) return;
    std::erase_if(members_, [&](int i) { return is_left_[i] == 0; });
    build();
  }

  /// Whether `is(corner)` holds for a corner in a triangle that turns left; corners near it may be tested as well.
  template <class Is>
  [[nodiscard]] bool any_in(const std::array<Vec2, 3>& triangle, const Is& is) const {
    const Vec2 &a = triangle[0], &b = triangle[1], &c = triangle[2];
    const Vec2 min = glm::min(a, glm::min(b, c)), max = glm::max(a, glm::max(b, c));
    const search::Bounds<2> around{{{min.x, max.x}, {min.y, max.y}}};
    const auto may_hold = [&](const search::Bounds<2>& box) {
      return search::meet<2>(box, around) && reaches(box, a, b) && reaches(box, b, c) && reaches(box, c, a);
    };
    bool found = false;
    tree_.visit_where(may_hold, [&](std::size_t i) {
      found = is_left_[members_[i]] != 0 && is(members_[i]);
      return !found;
    });
    return found;
  }

 private:
  /// Whether a box has points to the left of a line or on it. Rounded areas grow and fall with the point as exact ones
  /// do, so the box's corner farthest to the left has the largest of them.
  static bool reaches(const search::Bounds<2>& box, Vec2 a, Vec2 b) {
    return area(a, b, {box[0][b.y > a.y ? 0 : 1], box[1][b.x > a.x ? 1 : 0]}) >= 0;
  }

  void build() {
    search::order_by_halving(members_.begin(), members_.end(), [&](int i) { return p_[i]; });
    tree_ = {members_.size(), [&](std::size_t i) {
               const Vec2& p = p_[members_[i]];
               return search::Bounds<2>{{{p.x, p.x}, {p.y, p.y}}};
             }};
  }

  const std::vector<Vec2>& p_;
  std::vector<char> is_left_;
  std::size_t left_;
  std::vector<int> members_;  ///< in the order of the tree
  search::BoundsTree<2> tree_;
};

class EarClipper {
 public:
  explicit EarClipper(const std::vector<Vec2>& places)
      : p_(places), next_(places.size()), previous_(places.size()), corners_(places) {
    const int count = static_cast<int>(places.size());
    for (int i = 0; i < count; ++i) {
      next_[i] = i + 1 == count ? 0 : i + 1;
      previous_[i] = i == 0 ? count - 1 : i - 1;
      open_.insert(open_.end(), i);
    }
  }

  /// Calls `take(a, b, c)` for each triangle. Returns whether it could look for ears to the end.
  template <class Take>
  bool clip(const Take& take) {
    int at = 0;
    for (std::size_t left = p_.size(); left > 2; --left) {
      at = choose(at, left);
      take(previous_[at], at, next_[at]);
      corners_.remove(at);
      open_.erase(at);
      open_.insert({previous_[at], next_[at]});
      next_[previous_[at]] = next_[at];
      previous_[next_[at]] = previous_[at];
      at = next_[at];
    }
    return work_ < max_work;
  }

 private:
  /// The first ear, beginning at `start`. A polygon that crosses itself may have none: then a corner without area or,
  /// failing that, any convex one.
  int choose(int start, std::size_t left) {
    if (const int ear = first_ear(start); ear >= 0) return ear;
    // Where the polygon crosses itself, a cut may also free a corner that is no neighbour.
    int flat = -1, convex = -1, at = start;
    for (std::size_t i = 0; i < left && work_ < max_work; ++i, at = next_[at], ++work_) {
      if (is_ear(at)) return at;
      const double size = area(p_[previous_[at]], p_[at], p_[next_[at]]);
      if (size == 0 && flat < 0) flat = at;
      if (size > 0 && convex < 0) convex = at;
    }
    return flat >= 0 ? flat : convex >= 0 ? convex : start;
  }

  /// The first ear in `open_`, beginning at `start`, or -1.
  int first_ear(int start) {
    for (auto at = open_.lower_bound(start); !open_.empty() && work_ < max_work; ++work_) {
      if (at == open_.end()) at = open_.begin();
      if (is_ear(*at)) return *at;
      at = open_.erase(at);
    }
    return -1;
  }

  /// Whether the corner is strictly convex, its diagonal is inside the polygon at both ends, and no other corner is in
  /// its triangle.
  bool is_ear(int at) {
    const int before = previous_[at], behind = next_[at];
    const Vec2 a = p_[before], b = p_[at], c = p_[behind];
    if (!(area(a, b, c) > 0) || !sees(before, c) || !sees(behind, a)) return false;
    return !corners_.any_in({a, b, c}, [&](int other) {
      ++work_;
      const Vec2 q = p_[other];
      if (q == a || q == b || q == c) return false;  // also at bridges; `sees` has tested the edges from there
      return area(a, b, q) >= 0 && area(b, c, q) >= 0 && area(c, a, q) >= 0;
    });
  }

  /// Whether `target` lies strictly between the two edges of a corner, on the side of the polygon.
  [[nodiscard]] bool sees(int corner, Vec2 target) const {
    const Vec2 before = p_[previous_[corner]], at = p_[corner], behind = p_[next_[corner]];
    const bool left_of_next = area(at, behind, target) > 0, left_of_last = area(before, at, target) > 0;
    // At a reflex corner it suffices to be on the inner side of one edge.
    return area(before, at, behind) > 0 ? left_of_next && left_of_last : left_of_next || left_of_last;
  }

  // Bounds the time for polygons with many thousand corners but hardly any ears: the rest becomes a fan.
  static constexpr long long max_work = 400'000'000;

  const std::vector<Vec2>& p_;
  std::vector<int> next_, previous_;
  CornerTree corners_;
  /// The corners that may be ears: a corner that is none becomes one only when a neighbour is cut.
  std::set<int> open_;
  long long work_ = 0;
};

void add_triangles(Triangulation& result, std::span<const int> ring, int number, const Points& points) {
  Faces& triangles = result.triangles;
  const auto take = [&](int a, int b, int c) {
    if (ring[a] == ring[b] || ring[b] == ring[c] || ring[c] == ring[a]) return;
    triangles.corners.insert(triangles.corners.end(), {ring[a], ring[b], ring[c]});
    triangles.ends.push_back(static_cast<int>(triangles.corners.size()));
    triangles.number.push_back(number);
  };
  if (ring.size() == 3) return take(0, 1, 2);
  const std::vector<Vec2> flat = flattened(ring, points);
  if (is_fan(flat))
    for (int i = 2; i < static_cast<int>(ring.size()); ++i) take(0, i - 1, i);
  else if (!EarClipper(flat).clip(take) && (result.unfinished.empty() || result.unfinished.back() != number))
    result.unfinished.push_back(number);
}

}  // namespace

Triangulation triangulate(Faces faces, const Points& points, const Progress& progress) {
  if (faces.corners.size() == 3 * faces.size()) return {std::move(faces)};  // no face has fewer than three corners
  Triangulation result;
  result.triangles.corners.reserve(3 * (faces.corners.size() - 2 * faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (f % faces_a_look == 0) progress.expect_time();
    const auto ring = faces.ring(f);
    if (!repeats_corner(ring)) {
      add_triangles(result, ring, faces.number[f], points);
      continue;
    }
    for (const auto& simple : simple_rings(ring, points)) add_triangles(result, simple, faces.number[f], points);
  }
  return result;
}

}  // namespace epura::mesh
