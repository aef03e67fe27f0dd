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

/// Returns pieces in the order of edges, with the hidden ones of moved contours, whatever is kept. Throws OutOfTime.
SettledPieces settled_pieces(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                             const DrawingOptions& options, const Progress& progress = {});

}  // namespace epura::drawing
