// SPDX-License-Identifier: Apache-2.0
// Recognises the lines of a drawing that are tessellated arcs of circles and ellipses.
#pragma once

#include <cmath>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "drawing/known_circles.hpp"

namespace epura::drawing {

/// The result of find_curves; lengths in mm.
struct CurveReport {
  int circles = 0, ellipses = 0;  ///< including arcs of them
  double deviation = 0;           ///< largest distance of a corner from its curve
  double bulge = 0;               ///< largest height of a curve over the chord that it replaces

  CurveReport& operator+=(const CurveReport& other);
};

/// How closely lines are taken for curves; lengths in mm.
struct CurveLimits {
  double tolerance;            ///< greatest distance of corners from their curve
  double max_rise = HUGE_VAL;  ///< curves that rise more over a chord are left out
  std::vector<char> exact =
      {};  ///< by chain: whether its corners are known better than that, and keep to a tenth of it
};

/// Fills Chain::curves: greedily takes the longest runs of corners that lie within the tolerance of a circle, or else
/// of an ellipse. A circle in space is an ellipse on paper, on which its corners keep their angles. A run goes around
/// in one direction, in steps of at most 30 degrees of the curve's angle, so that polygons with fewer than twelve sides
/// stay polygons; it has at least eight corners and turns by at least 30 degrees. An end of an open line that lies on a
/// chord of the curve is moved onto the curve. A closed line is made to begin where no curve continues past its end.
/// On a known circle, two corners are enough, and steps may be up to 90 degrees; a whole open line on it needs no
/// corner. Throws OutOfTime.
CurveReport find_curves(std::vector<Chain>& chains, const CurveLimits& limits, const KnownCircles& known = {},
                        const Progress& progress = {});

}  // namespace epura::drawing
