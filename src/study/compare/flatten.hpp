// Curves as lines.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura {

/// How many equal parts a curve is cut into, whose chord would be off by `sagitta` mm if it were one: that falls with
/// the square of the number. The parts stay within 0.0001 mm of it.
int parts_of_curve(double sagitta);

/// Appends points of a cubic Bezier curve, without its beginning. By value: `from` may be one of `points`.
void append_cubic(std::vector<Vec2>& points, Vec2 from, Vec2 a, Vec2 b, Vec2 to);

}  // namespace epura
