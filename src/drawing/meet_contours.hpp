// SPDX-License-Identifier: Apache-2.0
// Contours are drawn on the surface, not on the mesh (edges/smooth_contours.hpp). This makes lines that end at a
// contour of the mesh, because it hides the rest of them, end at the contour that is drawn.
#pragma once

#include <vector>

#include "drawing/ink.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

/// Moves those ends of pieces that lie within `tolerance` mm of a visible contour of the mesh to where the contour is
/// drawn.
void meet_contours(const visibility::ResolvedView& lines, const view::PaperMap& paper, double tolerance,
                   std::vector<Piece>& pieces);

}  // namespace epura::drawing
