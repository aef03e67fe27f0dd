// SPDX-License-Identifier: Apache-2.0
// Draws contours of recognised cylinders and cones on the surface.
//
// Facets draw an edge up to half a facet beside the generator whose normal is perpendicular to the projectors. On the
// page, this generator touches the ellipses of the rims, beyond their chords: so only drawings with arcs have room for
// it. Arcs that end at the edge are made to end where the generator touches them, and the generator where it meets what
// hides the rest of it.
#pragma once

#include "drawing/drawing.hpp"
#include "world/world.hpp"

namespace epura::drawing {

/// Moves contours in a parallel projection, and arcs that end there. Contours that end where they cross another face
/// stay: that place is no more accurate than facets are. Call it after find_curves. Returns the largest distance moved,
/// mm.
double move_contours(const world::World& world, ViewDrawing& drawing);

}  // namespace epura::drawing
