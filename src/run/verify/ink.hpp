// SPDX-License-Identifier: Apache-2.0
// Finds out whether a drawing has ink at given positions.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "drawing/view_drawing.hpp"

namespace epura::verify {

/// A place on the page, mm, where a line is expected.
struct Expected {
  Vec2 place;
  bool visible;  ///< whether it must be visible; otherwise any line will do
};

/// Returns for each place whether such a segment passes within `reach` mm of it.
std::vector<bool> find_ink(const drawing::ViewDrawing& drawing, const std::vector<Expected>& places, double reach);

}  // namespace epura::verify
