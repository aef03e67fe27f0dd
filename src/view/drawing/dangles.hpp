// SPDX-License-Identifier: Apache-2.0
// Lines so short that nobody sees them on the ink beside them. Rounding leaves many where faces nearly touch.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/continue_lines.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// Where a line that is not drawn in its place on the mesh changes between visible and hidden and back within `most`
/// mm, less than anyone sees, it does not; where it does so again and again, it is one of both. `is_moved` is by piece.
/// Throws OutOfTime.
std::vector<Piece> vote_on_visibility(std::vector<Piece> pieces, const std::vector<char>& is_moved, double most,
                                      const Progress& progress);

/// Drops polylines no longer than the distance whose ends both lie within that distance of longer lines that are drawn,
/// and are visible if they are. Links that continue no line stay unless they are too short to be seen, or begin
/// where other lines continue each other. `strength` is by piece: a negative one means no ink. Throws OutOfTime.
LeftInk drop_dangles(std::vector<Piece> pieces, const std::vector<signed char>& strength,
                     const ContinuingLimits& limits, const Progress& progress = {});

}  // namespace epura::drawing
