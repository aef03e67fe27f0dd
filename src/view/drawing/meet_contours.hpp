// SPDX-License-Identifier: Apache-2.0
// Contours are drawn on the surface, not on the mesh (edges/smooth_contours.hpp). This makes lines that end at a
// contour of the mesh, because it hides the rest of them, end at the contour that is drawn, and contours where another
// one hides them as both are drawn (t_junctions.hpp).
#pragma once

#include <vector>

#include "drawing/ink.hpp"
#include "drawing/t_junctions.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

/// Moves T-junctions, which turns and divides pieces, and then those other ends that lie within `tolerance` mm of a
/// visible contour of the mesh to where the contour is drawn. Pieces are in the order that move_t_junctions needs.
/// Returns which ends T-junctions settle, by piece.
std::vector<SettledEnds> meet_contours(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                                       double tolerance, std::vector<Piece>& pieces);

}  // namespace epura::drawing
