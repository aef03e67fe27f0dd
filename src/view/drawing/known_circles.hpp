// SPDX-License-Identifier: Apache-2.0
// Circles of the part on which edges of its mesh lie: rims of bores, ends of fillets, borders between turned faces.
#pragma once

#include <vector>

#include "drawing/conic_fit.hpp"
#include "drawing/drawing.hpp"
#include "drawing/part_edges.hpp"

namespace epura::drawing {

struct KnownCircles {
  std::vector<Ellipse> ellipses;           ///< images of circles on paper, mm
  std::vector<std::vector<int>> of_chain;  ///< by chain, which of these is that of the line from each point to the
                                           ///< next, or -1; empty if there is none
};

/// In a parallel projection, where circles become ellipses with the same angles; nothing in a central one. A border
/// between two recognised faces is a circle if all its vertices are at one height along the axis of a face, and at one
/// distance from it.
KnownCircles known_circles(const PartEdges& edges, const ViewDrawing& drawing);

}  // namespace epura::drawing
