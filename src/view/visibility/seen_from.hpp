// SPDX-License-Identifier: Apache-2.0
// Directions on the page around a point where many triangles meet.
#pragma once

#include <array>
#include <numbers>

#include "base/angle.hpp"
#include "view/projected_scene.hpp"
#include "visibility/hiding_rule.hpp"

namespace epura::visibility {

/// An interval of directions, counterclockwise from the first to the second, in radians. The first is in -pi to pi.
using Turn = std::array<double, 2>;

constexpr Turn all_around{-std::numbers::pi, std::numbers::pi};

inline bool turns_meet(const Turn& a, const Turn& b) {
  for (const double around : {0.0, full_turn, -full_turn})
    if (a[0] <= b[1] + around && b[0] + around <= a[1]) return true;
  return false;
}

/// The directions in which things lie from a place of the page grid. A triangle with a corner there overlaps an edge
/// that begins there only if its interval contains the direction of the edge. For all others, the intervals, widened by
/// the effect of rounding, must intersect.
class SeenFrom {
 public:
  SeenFrom(const view::ProjectedScene& view, const view::GridPoint& place);

  [[nodiscard]] bool is_at(const view::GridPoint& point) const { return point.x == place_.x && point.y == place_.y; }
  [[nodiscard]] Turn of_triangle(const view::ProjectedScene& view, const view::ViewTriangle& triangle) const;
  /// Of an edge that begins or ends here.
  [[nodiscard]] Turn of_edge(const view::ProjectedScene& view, const PageEdge& edge) const;
  /// Of a line between two places of the page.
  [[nodiscard]] Turn of_line(const Vec2& a, const Vec2& b) const;

 private:
  [[nodiscard]] Vec2 way_to(const view::GridPoint& point) const;

  view::GridPoint place_;
  double cell_;
};

}  // namespace epura::visibility
