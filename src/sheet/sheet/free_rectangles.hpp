// SPDX-License-Identifier: Apache-2.0
// The free area of a partly occupied sheet.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "sheet/rectangle.hpp"

namespace epura::sheet {

/// The maximal rectangles of `room` that do not overlap the `taken` ones: every free part of the room lies in one of
/// them, and none lies inside another. They may overlap each other.
std::vector<Rectangle> free_rectangles(const Rectangle& room, std::span<const Rectangle> taken);

/// The lower left corner for a box of this size in the free part of `room`, 3 mm from everything that is taken, as near
/// as possible to the point `towards`. Nothing if there is none.
std::optional<Vec2> nearest_free_position(const Rectangle& room, std::span<const Rectangle> taken, const Vec2& size,
                                          const Vec2& towards);

}  // namespace epura::sheet
