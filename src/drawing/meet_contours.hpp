// SPDX-License-Identifier: Apache-2.0
// Contours are drawn where the surface has them, not where the mesh has them (edges/smooth_contours.hpp): lines that end
// at a contour of the mesh, since it hides what follows, are to end at the drawn one.
#pragma once

#include <vector>

#include "drawing/ink.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

/// Moves ends of pieces that lie within `tolerance` mm of a visible contour of the mesh, to where that is drawn.
void meet_contours(const visibility::ResolvedView& lines, const view::PaperMap& paper, double tolerance,
                   std::vector<Piece>& pieces);

}  // namespace epura::drawing
