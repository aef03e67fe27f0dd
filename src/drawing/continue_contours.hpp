// SPDX-License-Identifier: Apache-2.0
// Facets of a curved surface draw its contour in parts that end beside one another. This makes them one line.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// Where two contours of one model and visibility run in the same direction to ends that overlap or nearly meet, no
/// farther than `distance` mm apart, cuts off the overlap of one of them and makes it begin where the other one ends.
/// `models` are by piece; pieces that are not drawn are left alone. Throws OutOfTime.
std::vector<Piece> continue_contours(std::vector<Piece> pieces, const std::vector<int>& models, double distance,
                                     const Progress& progress = {});

}  // namespace epura::drawing
