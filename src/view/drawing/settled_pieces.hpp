// SPDX-License-Identifier: Apache-2.0
// The pieces of all lines, with the ends that they have as they are drawn.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"
#include "drawing/make_drawing.hpp"
#include "drawing/t_junctions.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

struct SettledPieces {
  std::vector<Piece> pieces;
  std::vector<SettledEnds> settled;  ///< by piece
  double meeting;                    ///< mm; ends within it of a line, both in the mesh, are on it
};

/// Contours are drawn on the surface, not on the mesh (edges/smooth_contours.hpp). Makes lines that end at a contour of
/// the mesh, because it hides the rest of them, end at the contour that is drawn, and contours where another one hides
/// them as both are drawn: moves T-junctions (t_junctions.hpp), which turns and divides pieces, and then those other
/// ends that lie within `tolerance` mm of a visible contour of the mesh to where the contour is drawn. Pieces are in
/// the order that move_t_junctions needs. Returns which ends T-junctions settle, by piece.
std::vector<SettledEnds> meet_contours(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                                       double tolerance, std::vector<Piece>& pieces);

/// Returns pieces in the order of edges, with the hidden ones of moved contours, whatever is kept. Throws OutOfTime.
SettledPieces settled_pieces(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                             const DrawingOptions& options, const Progress& progress = {});

}  // namespace epura::drawing
