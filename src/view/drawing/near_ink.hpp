// SPDX-License-Identifier: Apache-2.0
// Of lines that run along each other so closely that a person sees one, only one is drawn, in its own place.
//
// Pieces are taken polyline by polyline, the strongest first, and the longest first among those of equal strength: this
// keeps a rim in one piece and removes what protrudes beside it. A part of a polyline is near if ink that stays runs in
// about the same direction at no more than the distance. Directions are measured over a few distances, since shorter
// pieces have none of their own. Short remainders between near parts and at the ends of polylines are removed, too, if
// ink lies around them: the corners of adjacent outlines are sqrt(2) times as far apart as their sides.
//
// Lines that cross or meet at a small angle are near each other around that point, and yet nobody mistakes them for one
// line: where a near part ends and the polyline continues, it counts as near only up to the place where it last meets
// the other line. Ends that would be left unconnected are joined to the ink that is drawn instead of the removed ink.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

/// Returns what is left of `pieces`, in their order. `strength` is by piece. Lines within `touching` mm meet. Throws
/// OutOfTime.
std::vector<Piece> join_near(std::vector<Piece> pieces, const std::vector<signed char>& strength, double distance,
                             double touching, const Progress& progress = {});

}  // namespace epura::drawing
