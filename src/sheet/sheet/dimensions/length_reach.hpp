// SPDX-License-Identifier: Apache-2.0
// How far a view reaches beside a length, beyond which its dimension line lies.
#pragma once

#include <algorithm>

#include "drawing/view_drawing.hpp"
#include "sheet/dimensions/measure.hpp"

namespace epura::sheet {

struct Reach {
  double min = 0, max = 0;

  void add(double value) {
    min = std::min(min, value);
    max = std::max(max, value);
  }
};

/// How far the ink reaches to the left of the line through `from`: all ink if the line is parallel to a side of the
/// paper, otherwise the ink between the extension lines.
Reach reach_of_ink(const MeasuredLength& length, const drawing::ViewDrawing& drawing);

/// 1 if `across` points upwards, or to the right; otherwise -1.
double sign_of_offset(const Vec2& across);

/// The side on which a dimension line in a direction is by preference, below or on the right: 1 to its left, or -1.
double first_side(const Vec2& along);

}  // namespace epura::sheet
