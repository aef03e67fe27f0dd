// SPDX-License-Identifier: Apache-2.0
// Arcs of circles and ellipses as cubic Bezier curves, and as arcs of at most a quarter, for file formats.
#pragma once

#include <array>
#include <vector>

#include "drawing/curve_part.hpp"

namespace epura::output {

/// A cubic curve that begins at the current point.
struct BezierPiece {
  std::array<Vec2, 2> controls;
  Vec2 to;
};

/// Within `tolerance` mm of the curve: pieces of angle t have their control points 4/3 tan(t/4) tangents away, which
/// leaves an error of 2.73e-4 (t / 90 degrees)^6 radii (Goldapp. Approximation of circular arcs by cubic polynomials.
/// CAGD 8, 1991).
std::vector<BezierPiece> bezier_pieces(const drawing::CurvePart& curve, double tolerance = 1e-5);

/// Ends of arcs of at most a quarter turn; from these and the radii, programs can compute the centre accurately.
std::vector<Vec2> quarter_ends(const drawing::CurvePart& curve);

}  // namespace epura::output
