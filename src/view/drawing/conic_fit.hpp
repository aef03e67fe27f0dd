// SPDX-License-Identifier: Apache-2.0
// Least-squares ellipse through points of the plane.
#pragma once

#include <cmath>
#include <optional>
#include <span>

#include "base/portable_math.hpp"
#include "base/vec.hpp"

namespace epura::drawing {

/// Points centre + cos(a) u + sin(a) v; u is perpendicular to v and turns into it counterclockwise.
struct Ellipse {
  Vec2 centre, u, v;

  [[nodiscard]] Vec2 at(double angle) const { return centre + portable_cos(angle) * u + portable_sin(angle) * v; }
  /// The angle whose ray from the centre passes through `p`.
  [[nodiscard]] double angle_of(const Vec2& p) const {
    const Vec2 d = p - centre;
    return portable_atan2(glm::dot(d, v) / glm::dot(v, v), glm::dot(d, u) / glm::dot(u, u));
  }
  /// Distance between the ellipse and a point near it, to first order (Sampson).
  [[nodiscard]] double distance(const Vec2& p) const;
};

/// Algebraic least squares, a x^2 + b x y + c y^2 + d x + e y = f with a + c = 1 (Gander, Golub, Strebel. Least-Squares
/// Fitting of Circles and Ellipses. BIT 34, 1994), after an affine map that makes the points' covariance the identity:
/// exact for points on an ellipse. Returns nothing for fewer than 5 points, for collinear points, and if the best conic
/// is not an ellipse.
std::optional<Ellipse> fit_ellipse(std::span<const Vec2> points);

}  // namespace epura::drawing
