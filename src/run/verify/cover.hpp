// SPDX-License-Identifier: Apache-2.0
// The effect of one triangle on the ray from a point to the viewer.
//
// A small square of rays around this ray is tested: the answer for the point is certain only if it does not change
// within the guaranteed tolerance of positions on the page.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "verify/polygon.hpp"
#include "verify/sight.hpp"

namespace epura::verify {

/// Lengths in mm of paper.
struct Tolerance {
  double size;     ///< longest side of the drawing
  double contact;  ///< a face hides what lies behind it by more than this times its steepness, in depth

  double rounding = 0;  ///< by how much rounding in the files may have moved a point relative to a triangle

  /// Half the side of the square: the precision that is guaranteed for every position on the page (docs/numerics.md).
  [[nodiscard]] double sideways() const { return std::max(1e-9 * size, rounding); }
};

/// The part of a triangle that lies in front of the square of rays.
struct Portion {
  int triangle;              ///< of the world
  bool in_front;             ///< certainly in front of the point by more than contact; otherwise perhaps
  double depth;              ///< distance in front of the point, mm
  std::vector<Vec2> corner;  ///< on the page relative to the point, in half sides of the square; empty unless in front
};

/// Looks from one point towards the viewer: in doubles with error bounds, and in rationals where these leave doubt.
class Lookout {
 public:
  /// The point is a + t (b - a) on `line`.
  Lookout(const Viewing& viewing, const Tolerance& tolerance, const std::array<Vec3, 2>& line, double t);

  /// Returns nothing if the triangle certainly does not hide the point. `joined`: the triangle shares a corner with the
  /// point's edge and hides it even if it is less than contact in front of it.
  [[nodiscard]] std::optional<Portion> look(const std::array<Vec3, 3>& corners, int triangle, bool joined) const;

 private:
  const Viewing* viewing_;
  const Tolerance* tolerance_;
  std::array<Vec3, 2> line_;
  double t_;
  Sight<Bounded> sight_;
};

}  // namespace epura::verify
