// SPDX-License-Identifier: Apache-2.0
// How far contours of recognised faces, as they are drawn, may end from where those of the surfaces do.
#pragma once

#include "accuracy/view_error.hpp"

namespace epura::accuracy {

/// Returns the longest side of a facet along which such a contour is drawn, on paper, mm.
double longest_drawn(const ViewToJudge& judged);

/// Returns the largest distance on paper, mm. Throws OutOfTime.
double off_at_drawn_ends(const ViewToJudge& judged, const Progress& progress);

}  // namespace epura::accuracy
