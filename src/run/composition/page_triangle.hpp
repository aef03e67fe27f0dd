// SPDX-License-Identifier: Apache-2.0
// The depth of a triangle at points of the page.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "base/vec.hpp"

namespace epura::pipeline {

/// A triangle by its corners on the page, mm, and their depths.
class PageTriangle {
 public:
  explicit PageTriangle(const std::array<Vec3, 3>& corners)
      : corner_(corners[0]),
        ab_(corners[1] - corners[0]),
        ac_(corners[2] - corners[0]),
        area_(cross(Vec2(ab_), Vec2(ac_))) {}

  /// Seen from the side it covers no point.
  [[nodiscard]] bool is_edge_on() const { return area_ == 0 || !std::isfinite(area_); }

  /// Nothing beside the triangle, which is not seen edge-on.
  [[nodiscard]] std::optional<double> depth_at(const Vec2& place) const {
    const Vec2 p = place - Vec2(corner_);
    const double s = cross(p, Vec2(ac_)) / area_, t = cross(Vec2(ab_), p) / area_;
    if (s < 0 || t < 0 || s + t > 1) return std::nullopt;
    return corner_.z + s * ab_.z + t * ac_.z;
  }

 private:
  Vec3 corner_, ab_, ac_;
  double area_;
};

}  // namespace epura::pipeline
