// SPDX-License-Identifier: Apache-2.0
// Lines that run along each other so near that a person sees one: one of them is drawn, in its own place.
//
// Pieces are taken polyline by polyline, the strongest first, of one strength the longest: so a rim stays whole, and
// what peeps out beside it goes. A stretch of a polyline is near where ink that stays runs in about its direction, at
// no more than the distance. Directions are those of a stretch of a few distances, since shorter pieces have none of
// their own. Between near stretches and at the ends of polylines short rests go, too, where ink lies around them:
// corners of outlines beside each other are sqrt(2) times as far apart as their sides.
//
// Lines that cross at a slight angle, or meet at one, are near each other around that point, and yet nobody takes them
// for one: where a near stretch ends and the polyline goes on, it is only near from the place on where it last meets
// the other line. Ends that would stand in the air without what is taken away are joined to the ink that stays for it.
#pragma once

#include <functional>
#include <numbers>
#include <vector>

#include "base/progress.hpp"
#include "drawing/ink.hpp"

namespace epura::drawing {

struct NearLines {
  double distance = 0;  ///< mm of paper; 0: all lines are drawn
  /// By model, kind, and visibility: of two lines the one with the greater number is drawn; below 0 it is no ink.
  std::function<int(int, EdgeKind, bool)> strength{};

  /// Ink that was taken away has ink that stays within so many mm.
  [[nodiscard]] double reach() const { return std::numbers::sqrt2 * distance; }
};

/// What is left of `pieces`, in their order. `strength` is by piece. Lines within `touching` mm meet. Throws OutOfTime.
std::vector<Piece> join_near(std::vector<Piece> pieces, const std::vector<signed char>& strength, double distance,
                             double touching, const Progress& progress = {});

}  // namespace epura::drawing
