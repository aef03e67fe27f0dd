// SPDX-License-Identifier: Apache-2.0
// Draws contours of recognised cylinders and cones on the surface, and ends lines where what hides the rest of them is
// drawn.
//
// Facets draw a contour up to half a facet beside the generator whose normal is perpendicular to the projectors. On the
// page, this generator touches the ellipses of the rims, beyond their chords: so only drawings with arcs have room for
// it. Arcs that end at the edge are made to end where the generator touches them, and the generator where it meets what
// hides the rest of it. So do all lines that arcs or such contours hide, and arcs that anything hides: facets hide them
// elsewhere.
#pragma once

#include <array>
#include <vector>

#include "drawing/drawing.hpp"
#include "drawing/exact_crossings.hpp"
#include "drawing/part_edges.hpp"

namespace epura::drawing {

/// Where the first and the last point of a line are on facets.
using EndsOnFacets = std::array<Vec2, 2>;

/// Moves contours in a parallel projection, arcs that end there, and ends of lines that something hides; none of these
/// by more than a facet. Contours that cross another face end where `crossings` has them, or else stay. Call it after
/// find_curves; `ends` are those of each chain before that.
void move_contours(const PartEdges& edges, const ExactCrossings& crossings, const std::vector<EndsOnFacets>& ends,
                   double touching, ViewDrawing& drawing);

}  // namespace epura::drawing
