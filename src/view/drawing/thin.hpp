// SPDX-License-Identifier: Apache-2.0
// Reduces a drawing to fewer lines when time is short.
#pragma once

#include <cstddef>

#include "drawing/view_drawing.hpp"

namespace epura::drawing {

/// Keeps the `count` longest chains and their segments, in order. Returns the number of segments removed.
std::size_t keep_longest_chains(ViewDrawing& drawing, std::size_t count);

}  // namespace epura::drawing
