// SPDX-License-Identifier: Apache-2.0
// How far a view reaches beside a length, beyond which its dimension line lies.
#pragma once

#include <algorithm>

#include "dimensions/measure.hpp"
#include "drawing/view_drawing.hpp"

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

/// How far on its way an extension line meets a line of the part, which may consist of pieces, that goes from one side
/// of it to the other, mm; HUGE_VAL if none does.
double way_to_part(const Vec2& from, const Vec2& to, const drawing::ViewDrawing& drawing);

}  // namespace epura::sheet
