// SPDX-License-Identifier: Apache-2.0
// Affine maps of the plane.
#pragma once

#include <cmath>

#include "base/vec.hpp"

namespace epura::svg {

/// x' = along * x + across * y + shift. SVG 1.1, 7.4: matrix(along across shift); ISO 32000-1, 8.3.3: the same.
struct AffineMap {
  Vec2 along{1, 0}, across{0, 1}, shift{0, 0};

  [[nodiscard]] Vec2 operator()(const Vec2& p) const { return along * p.x + across * p.y + shift; }

  /// Applies `inner` first, then this map.
  [[nodiscard]] AffineMap after(const AffineMap& inner) const {
    return {(*this)(inner.along) - shift, (*this)(inner.across) - shift, (*this)(inner.shift)};
  }

  /// The average factor by which it enlarges lengths.
  [[nodiscard]] double scale() const { return std::sqrt(std::abs(cross(along, across))); }
};

}  // namespace epura::svg
