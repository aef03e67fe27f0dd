// SPDX-License-Identifier: Apache-2.0
// Convex hulls of points of the plane.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/vec.hpp"

namespace epura {

/// Twice the area of a triangle, positive if a, b, c go around it counterclockwise.
inline double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

/// Whether the way from a by b to c does not turn left: b is no corner of a hull.
inline bool turns_no_left(const Vec2& a, const Vec2& b, const Vec2& c) { return turn(a, b, c) <= 0; }

/// Returns the items at the corners of the convex hull, counterclockwise; all of them if there are fewer than three.
/// `place_of` gives the place of an item, `is_no_corner` tells which corners to leave out, in the manner of
/// turns_no_left. (Andrew. Another efficient algorithm for convex hulls in two dimensions. Inf. Proc. Letters 9, 1979.)
template <class Item, class PlaceOf, class IsNoCorner = decltype(&turns_no_left)>
std::vector<Item> convex_hull(std::vector<Item> items, const PlaceOf& place_of,
                              const IsNoCorner& is_no_corner = &turns_no_left) {
  if (items.size() < 3) return items;
  std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
    return std::pair(place_of(a).x, place_of(a).y) < std::pair(place_of(b).x, place_of(b).y);
  });
  std::vector<Item> hull;
  const auto add_side = [&](auto next, const auto& last) {
    const std::size_t start = hull.size();
    for (; next != last; ++next) {
      while (hull.size() >= start + 2 &&
             is_no_corner(place_of(hull[hull.size() - 2]), place_of(hull.back()), place_of(*next)))
        hull.pop_back();
      hull.push_back(*next);
    }
    hull.pop_back();
  };
  add_side(items.begin(), items.end());
  add_side(items.rbegin(), items.rend());
  return hull;
}

}  // namespace epura
