// SPDX-License-Identifier: Apache-2.0
// What facets hide of the contours of their own surface, though the surface does not.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// Decides on pieces that facets alone hide (Piece::by_facets, visible until then). The facets in front have an outline
/// of their own, which mostly is drawn where the contour of the surface is. So a run of such pieces is hidden if other
/// visible lines lie within `distance` mm of all of it, and visible if they do not, since it closes a gap. Joins pieces
/// that continue each other on an edge; the order of edges stays. Throws OutOfTime.
void settle_doubts(std::vector<Piece>& pieces, double distance, const Progress& progress);

}  // namespace epura::drawing
