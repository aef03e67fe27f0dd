// SPDX-License-Identifier: Apache-2.0
// The arrows of auxiliary views at their parents. ISO 128-3: reference arrow method.
#pragma once

#include <span>
#include <string>

#include "drawing/drawing.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// An arrow at a parallel view.
struct SightArrow {
  std::string letter;
  Vec2 sight;   ///< direction in which the auxiliary view is seen, on the page; length 1
  Vec2 target;  ///< a point on its line, mm on paper
};

/// Layer VIEW/arrows: outside the ink of the view, arrows that point at it, with letters at their tails.
Layer sight_arrows(const drawing::ViewDrawing& view, std::span<const SightArrow> arrows, const LineWidths& widths);

/// How far an arrow and its letter extend past the ink on the side from which the view is seen, mm.
double sight_arrow_room(const LineWidths& widths);

/// The head of an arrow in a direction of sight, as cutting planes have, too: 30 degrees.
Fill sight_head(const Vec2& tip, const Vec2& sight, double length);

}  // namespace epura::sheet
