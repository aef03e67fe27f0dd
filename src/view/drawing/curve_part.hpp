// SPDX-License-Identifier: Apache-2.0
// Arcs that are parts of polylines: positions, lengths and sub-parts.
#pragma once

#include <span>
#include <vector>

#include "base/vec.hpp"

namespace epura::drawing {

/// A part of a polyline that is an arc: points first ... last lie on centre + cos(a) u + sin(a) v, where a runs from
/// `from` to `to` (radians). For a circle, u and v have the same length; for an ellipse, they are its semi-axes; u is
/// perpendicular to v. If a curve ends at the first point of a closed line, `last` is the number of points.
struct CurvePart {
  int first, last;
  Vec2 centre, u, v;
  double from, to;
};

/// Returns the point of a curve at an angle.
Vec2 position_on_curve(const CurvePart& curve, double angle);

/// Returns where a curve, between its ends, reaches farthest along either axis of the page.
std::vector<Vec2> outermost_places(const CurvePart& curve);

/// Returns the angles of the points first ... last of a polyline, from curve.from to curve.to.
std::vector<double> corner_angles(const CurvePart& curve, const std::vector<Vec2>& points);

/// Returns the length of a curve between two of its angles, mm.
double length_of_curve(const CurvePart& curve, double from, double to);

/// Returns the parts of curves between two points of the polyline, with points counted from `first`. In a closed
/// polyline, `last` may continue past its end.
std::vector<CurvePart> curves_between(std::span<const CurvePart> curves, const std::vector<Vec2>& points, int first,
                                      int last);

/// Returns the distance of each point from the first one along lines and curves; for a closed polyline, also its total
/// length, at the end.
std::vector<double> distances_along(const std::vector<Vec2>& points, bool closed, std::span<const CurvePart> curves);

}  // namespace epura::drawing
