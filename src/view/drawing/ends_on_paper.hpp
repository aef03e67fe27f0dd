// SPDX-License-Identifier: Apache-2.0
// Ends lines where what hides the rest of them is drawn.
//
// Facets hide lines where their own sides are. Arcs are drawn beside these, and so are crossings of surfaces: lines
// that they hide end at them, and so do arcs that anything hides.
#pragma once

#include <array>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/exact_crossings.hpp"

namespace epura::drawing {

/// Where the first and the last point of a line are on facets.
using EndsOnFacets = std::array<Vec2, 2>;

/// Moves ends of lines in a parallel projection that something hides, by no more than a facet. Call it after
/// find_curves; `ends` are those of each chain before that.
void move_ends(const ExactCrossings& crossings, const std::vector<EndsOnFacets>& ends, double touching,
               ViewDrawing& drawing);

}  // namespace epura::drawing
