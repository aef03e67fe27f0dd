// SPDX-License-Identifier: Apache-2.0
// Parts of polylines that are arcs: positions, lengths and sub-parts.
#pragma once

#include <span>
#include <vector>

#include "drawing/drawing.hpp"

namespace epura::drawing {

/// The point of a curve at its angle.
Vec2 position_on_curve(const CurvePart& curve, double angle);

/// Angles of the points first ... last of a polyline, which run from curve.from to curve.to.
std::vector<double> corner_angles(const CurvePart& curve, const std::vector<Vec2>& points);

/// The length of a curve between two of its angles, mm.
double length_of_curve(const CurvePart& curve, double from, double to);

/// What of the curves is between two points of the polyline, its points counted from `first`. `last` may count on past
/// the end of a closed one.
std::vector<CurvePart> curves_between(std::span<const CurvePart> curves, const std::vector<Vec2>& points, int first,
                                      int last);

/// How far each point is from the first one along lines and curves; of a closed polyline one more: all its length.
std::vector<double> distances_along(const std::vector<Vec2>& points, bool closed, std::span<const CurvePart> curves);

}  // namespace epura::drawing
