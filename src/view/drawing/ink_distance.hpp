// SPDX-License-Identifier: Apache-2.0
// How far ink is from what it was before lines were merged: the Hausdorff distance of both.
//
// The distance of a point from a straight line is convex along another one, so no point between two others is farther
// from any line than the farther one of these. Where that does not tell, pieces are halved.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// Returns the distance between what is drawn of two sets of pieces, mm, to within the given precision and not more
/// than `most`. Visible ink is compared with visible ink, hidden ink with any. Throws OutOfTime.
double ink_distance(const std::vector<Piece>& before, const std::vector<Piece>& after, double precision, double most,
                    const Progress& progress = {});

}  // namespace epura::drawing
