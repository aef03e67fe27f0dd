// SPDX-License-Identifier: Apache-2.0
// Curves as polylines.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "compare/picture_maker.hpp"

namespace epura::compare {

/// How many equal parts a curve is cut into, whose chord would be off by `sagitta` mm if it were one: that falls with
/// the square of the number. The parts stay within 0.0001 mm of it.
int parts_of_curve(double sagitta);

/// Points of a cubic Bezier curve, the first one too.
struct CubicCurve {
  Vec2 from, a, b, to;
};

/// Appends points of a curve, without its beginning, as far as there is room.
void append_cubic(std::vector<Vec2>& points, const CubicCurve& curve, PieceRoom& room);

}  // namespace epura::compare
