// SPDX-License-Identifier: Apache-2.0
// Reduces a drawing to fewer lines when time is short.
#pragma once

#include <cstddef>

#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Keeps the `count` longest chains and the segments that are in them, in their order. Returns how many segments go.
std::size_t keep_longest_chains(ViewDrawing& drawing, std::size_t count);

}  // namespace epura::drawing
