// SPDX-License-Identifier: Apache-2.0
// What facets hide of the contours of their own surface, though the surface does not.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// Decides on pieces that facets alone hide (Piece::by_facets, visible until then). The facets in front have an outline
/// of their own, which mostly is drawn where the contour of the surface is. So a run of such pieces is hidden if other
/// visible lines run beside most of it, within `distance` mm, and else visible, since it closes a gap.
/// A distance of 0 hides all. Joins pieces that continue each other on an edge; the order of edges stays. Throws
/// OutOfTime.
std::vector<Piece> settle_doubts(std::vector<Piece> pieces, double distance, const Progress& progress);

}  // namespace epura::drawing
