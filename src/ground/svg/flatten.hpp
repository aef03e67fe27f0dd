// SPDX-License-Identifier: Apache-2.0
// Curves as polylines.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/vec.hpp"

namespace epura::svg {

/// How many more pieces of lines a file may contain. A line takes at least two bytes, but a piece of a curve takes
/// fewer.
class PieceRoom {
 public:
  /// Allows 250 000, and one for every two bytes. `where` names the file in errors.
  PieceRoom(std::size_t bytes, std::string where);

  /// Throws Error{input} if there are too many.
  void take(std::size_t pieces);

 private:
  std::string where_;
  std::size_t max_, left_;
};

/// The number of equal parts into which to divide a curve so that they stay within 0.0001 mm of it. `sagitta` is the
/// error of a single chord in mm; the error falls with the square of the number.
int parts_of_curve(double sagitta);

/// Points of a cubic Bezier curve, including the first one.
struct CubicCurve {
  Vec2 from, a, b, to;
};

/// Appends points of a curve, without its beginning. Throws Error{input} if there is no room for them.
void append_cubic(std::vector<Vec2>& points, const CubicCurve& curve, PieceRoom& room);

}  // namespace epura::svg
