// SPDX-License-Identifier: Apache-2.0
#include "refine/split_triangle.hpp"

#include <algorithm>
#include <cstddef>

#include "base/error.hpp"
#include "refine/limits.hpp"

namespace epura::refine {

namespace {

using Ring = std::vector<RingPoint>;

double area_of(const RingPoint& a, const RingPoint& b, const RingPoint& c) {
  return cross(b.in_triangle - a.in_triangle, c.in_triangle - a.in_triangle);
}

double area_of(const Ring& ring) {
  double area = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) area += area_of(ring[0], ring[i - 1], ring[i]);
  return area;
}

// Height over longest side, in space.
double quality_of(const RingPoint& a, const RingPoint& b, const RingPoint& c) {
  const Vec3 ab = b.place - a.place, ac = c.place - a.place, bc = c.place - b.place;
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return longest > 0 ? glm::length(glm::cross(ab, ac)) / longest : 0;
}

// Cuts off the best triangle at a corner, again and again. No triangle has all its corners on one side of the original.
void triangulate(Ring ring, std::vector<std::array<int, 3>>& triangles) {
  while (ring.size() >= 3) {
    const std::size_t count = ring.size();
    const double whole = area_of(ring);
    std::size_t best = count;
    double best_quality = -1;
    for (std::size_t i = 0; i < count; ++i) {
      const RingPoint &before = ring[(i + count - 1) % count], &after = ring[(i + 1) % count];
      const double area = area_of(before, ring[i], after);
      const double quality = quality_of(before, ring[i], after);
      const bool leaves_enough = count == 3 || whole - area > rounding_part;
      if (!(area > rounding_part) || !leaves_enough || !(quality > best_quality)) continue;
      best = i;
      best_quality = quality;
    }
    check(best < count, "a triangle is split into triangles");
    triangles.push_back({ring[(best + count - 1) % count].vertex, ring[best].vertex, ring[(best + 1) % count].vertex});
    if (count == 3) return;
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
}

}  // namespace

std::vector<std::array<int, 3>> split_triangle(const std::vector<RingPoint>& ring) {
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::ptrdiff_t> on_contour;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (ring[i].side == 0) on_contour.push_back(static_cast<std::ptrdiff_t>(i));
  const bool is_cut = on_contour.size() == 2;
  Ring one, other;
  if (is_cut) {
    const auto from = ring.begin() + on_contour[0], to = ring.begin() + on_contour[1];
    one.assign(from, to + 1);
    other.assign(to, ring.end());
    other.insert(other.end(), ring.begin(), from + 1);
  }
  if (is_cut && area_of(one) > rounding_part && area_of(other) > rounding_part) {
    triangulate(std::move(one), triangles);
    triangulate(std::move(other), triangles);
  } else {
    triangulate(ring, triangles);
  }
  return triangles;
}

}  // namespace epura::refine
