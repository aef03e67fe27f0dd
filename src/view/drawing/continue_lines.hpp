// SPDX-License-Identifier: Apache-2.0
// Facets of a curved surface draw its contour in parts that end beside one another. This makes them one line.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// In mm.
struct ContinuingLimits {
  double distance;  ///< greatest distance between the ends of lines that continue each other
  double touching;  ///< ends this close meet already
};

/// Where two contours of one model and visibility run in the same direction to ends that overlap or nearly meet, no
/// farther than the distance apart, cuts off the overlap of one of them and makes it begin where the other one ends.
/// `models` are by piece; pieces that are not drawn are left alone. Throws OutOfTime.
LeftInk continue_lines(std::vector<Piece> pieces, const std::vector<int>& models, const ContinuingLimits& limits,
                       const Progress& progress = {});

}  // namespace epura::drawing
