// SPDX-License-Identifier: Apache-2.0
// Whether a triangle hides a single point of an edge: the hiding rule in plain doubles, as used by methods that test
// points.
#pragma once

#include "visibility/hiding_rule.hpp"

namespace epura::study {

class PointRule {
 public:
  PointRule(const view::ProjectedScene& view, const visibility::PageEdge& edge) : view_(view), edge_(edge) {}

  [[nodiscard]] Vec2 position(double s) const;
  [[nodiscard]] double depth(double s) const;

  /// Whether the triangle, which must not be one of the edge's own, covers the point at page parameter `s` (on its
  /// border, too) and lies in front of it by more than contact.
  [[nodiscard]] bool hides(const view::ViewTriangle& triangle, double s) const;

  /// Whether the plane of the triangle lies in front of that point by more than contact.
  [[nodiscard]] bool lies_before(const view::ViewTriangle& triangle, double s) const;

 private:
  const view::ProjectedScene& view_;
  visibility::PageEdge edge_;
};

}  // namespace epura::study
