// SPDX-License-Identifier: Apache-2.0
// The effect of one triangle on the ray from a point to the viewer.
//
// A small square of rays around the ray is tested: the answer at the point is certain only if it does not change within
// the guaranteed tolerance of positions on the page.
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
  double size;     ///< of the drawing: its longest side
  double contact;  ///< a face hides what lies more than this times its steepness behind it, in depth

  double rounding = 0;  ///< how far rounding in the files may have moved a point and a triangle apart

  /// Half the side of the square: to this every place on the page is guaranteed (docs/numerics.md).
  [[nodiscard]] double sideways() const { return std::max(1e-9 * size, rounding); }
};

/// The part of a triangle before the square of rays.
struct Portion {
  int triangle;              ///< of the world
  bool in_front;             ///< surely before the point by more than contact; otherwise perhaps
  double depth;              ///< how far before it, mm
  std::vector<Vec2> corner;  ///< on the page from the point, the half side of the square being 1; empty unless in front
};

/// Looks from one point, first in doubles with bounds, and in rationals where those leave doubt.
class Lookout {
 public:
  /// The point is a + t (b - a) on `line`.
  Lookout(const Viewing& viewing, const Tolerance& tolerance, const std::array<Vec3, 2>& line, double t);

  /// Nothing: the triangle surely does not hide the point. `joined`: it shares a corner with the point's edge, and
  /// hides however little it lies before it.
  [[nodiscard]] std::optional<Portion> look(const std::array<Vec3, 3>& corners, int triangle, bool joined) const;

 private:
  const Viewing* viewing_;
  const Tolerance* tolerance_;
  std::array<Vec3, 2> line_;
  double t_;
  Sight<Bounded> sight_;
};

}  // namespace epura::verify
