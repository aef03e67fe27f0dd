// SPDX-License-Identifier: Apache-2.0
// Touching segments that look the same, of one model and named body, joined end to end into polylines.
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.hpp"
#include "drawing/continuations.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Every segment is in exactly one chain. Where more than two ends meet, the straightest continuations are joined.
/// Corners at which a chain runs straight on within `tolerance` mm are left out. Throws OutOfTime.
std::vector<Chain> chain_segments(const std::vector<Segment>& segments, double tolerance, const Gaps& gaps = {},
                                  const Progress& progress = {});

/// Makes the chains of a drawing anew. Throws OutOfTime.
void chain_lines(ViewDrawing& drawing, const Progress& progress);

/// Removes chains of creases shorter than `least` mm that meet no other line and end neither behind a face nor at the
/// edge of the view, with their segments. Returns whether there were any; then the chains must be made anew.
bool drop_short_creases(ViewDrawing& drawing, double least);

/// Keeps the `count` longest chains and their segments, in order, where time is too short for all of them. Returns the
/// number of segments removed.
std::size_t keep_longest_chains(ViewDrawing& drawing, std::size_t count);

}  // namespace epura::drawing
