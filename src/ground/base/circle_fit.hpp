// SPDX-License-Identifier: Apache-2.0
// Least-squares circle through points of the plane.
#pragma once

#include <optional>
#include <span>

#include "base/vec.hpp"

namespace epura {

struct FittedCircle {
  Vec2 centre;
  double radius;
  double deviation;  ///< largest distance of a point from the circle
};

/// Least squares of |p|^2 - 2 c.p - k (Kasa, A circle fitting procedure and its error analysis, IEEE Trans. Instrum.
/// Meas. 25, 1976): exact for points on a circle. Returns nothing for collinear points.
std::optional<FittedCircle> fit_circle(std::span<const Vec2> points);

}  // namespace epura
