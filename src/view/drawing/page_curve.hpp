// SPDX-License-Identifier: Apache-2.0
// Straight lines and ellipses on paper, and where two of them cross.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "base/vec.hpp"
#include "drawing/conic_fit.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// A whole line or ellipse, and the parameters between which a line of the drawing is a part of it.
class PageCurve {
 public:
  PageCurve(const Vec2& from, const Vec2& to) : shape_{from, to - from, {}}, range_{0, 1}, is_straight_(true) {}
  explicit PageCurve(const CurvePart& part)
      : shape_{part.centre, part.u, part.v}, range_{std::min(part.from, part.to), std::max(part.from, part.to)} {}

  [[nodiscard]] Vec2 at(double parameter) const {
    return is_straight_ ? shape_.centre + parameter * shape_.u : shape_.at(parameter);
  }
  [[nodiscard]] Vec2 derivative(double parameter) const;
  /// Of the nearest point of a straight line, or of the point of an ellipse on the ray from its centre.
  [[nodiscard]] double parameter_of(const Vec2& point) const;
  /// Of a point from that with its parameter: at least the distance from the curve.
  [[nodiscard]] double distance(const Vec2& point) const { return glm::distance(at(parameter_of(point)), point); }
  /// Whether a place on the whole curve is in the part.
  [[nodiscard]] bool is_in_part(const Vec2& place) const;
  /// The end of the part beyond which a place on the whole curve is.
  [[nodiscard]] Vec2 end_near(const Vec2& place) const;
  [[nodiscard]] bool is_straight() const { return is_straight_; }

 private:
  // That of a place, for an ellipse less than half a turn from the middle of the part.
  [[nodiscard]] double parameter_near_part(const Vec2& place) const;

  Ellipse shape_;  // of a straight line: a point of it, and in u its direction
  std::array<double, 2> range_;
  bool is_straight_ = false;
};

/// Returns where two curves cross near a point, by Newton's method; nothing if they do not cross there, or at too small
/// an angle.
std::optional<Vec2> crossing_near(const PageCurve& one, const PageCurve& other, const Vec2& point);

}  // namespace epura::drawing
