// SPDX-License-Identifier: Apache-2.0
// Traverses the lines and curves of a stroke in order.
#pragma once

#include <cstddef>

#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Calls line(point) for each line to a point and curve(part) for each curve, beginning at the first point. The closing
/// line of a closed stroke is left to the caller, unless a curve closes it.
template <class Line, class Curve>
void walk_stroke(const Stroke& stroke, const Line& line, const Curve& curve) {
  std::size_t at = 1;
  const auto lines_to = [&](std::size_t end) {
    for (; at < end; ++at) line(stroke.points[at]);
  };
  for (const drawing::CurvePart& part : stroke.curves) {
    lines_to(static_cast<std::size_t>(part.first) + 1);
    curve(part);
    at = static_cast<std::size_t>(part.last) + 1;
  }
  lines_to(stroke.points.size());
}

}  // namespace epura::sheet
