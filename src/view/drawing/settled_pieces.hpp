// SPDX-License-Identifier: Apache-2.0
// The pieces of all lines, with the ends that they have as they are drawn.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"
#include "drawing/make_drawing.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

struct SettledPieces {
  std::vector<Piece> pieces;
  double off_at_ends;  ///< by how much visible contours may end too early or too late, mm (TJunctions::off)
};

/// Returns pieces in the order of edges, with the hidden ones of moved contours, whatever is kept. Throws OutOfTime.
SettledPieces settled_pieces(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                             const DrawingOptions& options, const Progress& progress = {});

/// Returns SettledPieces::off_at_ends, at once where all contours are drawn in their places on the mesh. Throws
/// OutOfTime.
double off_at_contour_ends(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                           const DrawingOptions& options, const Progress& progress = {});

}  // namespace epura::drawing
