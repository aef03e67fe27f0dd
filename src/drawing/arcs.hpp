// SPDX-License-Identifier: Apache-2.0
// Recognises arcs of circles and ellipses among the lines of a drawing, which were tessellated in the mesh.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// What find_curves found; lengths in mm.
struct CurveReport {
  int circles = 0, ellipses = 0;  ///< and arcs of them
  double deviation = 0;           ///< largest distance of a corner from its curve
  double bulge = 0;               ///< largest height of a curve over the chord that it replaces

  CurveReport& operator+=(const CurveReport& other);
};

/// Fills Chain::curves: greedily the longest runs of corners that lie within `tolerance` mm of a circle, or else of an
/// ellipse. A circle in space is an ellipse on paper, its corners keep their angles: a run goes round one way in steps
/// of at most 30 degrees of the curve's angle, so that polygons with fewer than twelve sides stay polygons; it has
/// eight corners at least and turns by 30 degrees at least. The end of an open line that lies on a chord of the curve
/// is moved onto it. A closed line begins where no curve runs on past its end. Throws OutOfTime.
CurveReport find_curves(std::vector<Chain>& chains, double tolerance, const Progress& progress = {});

}  // namespace epura::drawing
