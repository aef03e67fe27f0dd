// SPDX-License-Identifier: Apache-2.0
// The area on paper that dimensions occupy, so that they do not collide.
#pragma once

#include <cmath>
#include <vector>

#include "base/vec.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/lettering.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// A rotated rectangle; a line if one half size is 0. Millimetres on paper.
struct TurnedBox {
  Vec2 centre;
  Vec2 along;  ///< length 1
  Vec2 half;   ///< half its size along and across
};

/// The bounding rectangle.
Rectangle around(const TurnedBox& box);

inline TurnedBox turned_box(const Rectangle& box) { return {box.centre(), {1, 0}, box.size() / 2.0}; }

TurnedBox line_box(const Vec2& from, const Vec2& to);

/// Whether both look parallel: 1.1 degrees.
inline bool look_parallel(const TurnedBox& one, const TurnedBox& other) {
  constexpr double sine = 0.02;
  return std::abs(cross(one.along, other.along)) <= sine;
}

/// Whether they share more than their borders.
bool overlap(const TurnedBox& a, const TurnedBox& b);

TurnedBox box_of(const Text& text, const Lettering& lettering);

/// The boxes of the lines, areas and texts of a layer.
std::vector<TurnedBox> boxes_of(const Layer& layer, const Lettering& lettering);

/// How many lines of the drawing pass through the box.
int ink_in(const TurnedBox& box, const drawing::ViewDrawing& drawing);

}  // namespace epura::sheet
