// SPDX-License-Identifier: Apache-2.0
// The free area of a partly occupied sheet.
#pragma once

#include <span>
#include <vector>

#include "sheet/rectangle.hpp"

namespace epura::sheet {

/// The maximal rectangles of `room` that do not overlap the `taken` ones: every free part of the room lies in one of
/// them, and none lies inside another. They may overlap each other.
std::vector<Rectangle> free_rectangles(const Rectangle& room, std::span<const Rectangle> taken);

}  // namespace epura::sheet
