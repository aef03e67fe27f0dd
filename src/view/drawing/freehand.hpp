// SPDX-License-Identifier: Apache-2.0
// Freehand lines: continuous lines with small irregular waves (type 01.1, ISO 128-2, ISO 128-3).
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::drawing {

/// Returns a closed freehand line along a smooth curve through points, mm on paper, three or more that do not lie on
/// one line. It is never farther than `freehand_wave` from that curve.
std::vector<Vec2> freehand_around(const std::vector<Vec2>& points);

/// Returns a freehand line along a straight one that is parallel to an axis: `along` 0 for x, 1 for y. Waves of lines
/// over the same places of that axis are the same.
std::vector<Vec2> freehand_along(int along, const Vec2& from, const Vec2& to);

/// How far such lines are off at a place on their axis, in the positive direction of the other one.
double freehand_offset(double place);

/// Returns points on a circle, close enough for a smooth curve through them.
std::vector<Vec2> points_on_circle(const Vec2& centre, double radius);

}  // namespace epura::drawing
