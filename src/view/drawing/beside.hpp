// SPDX-License-Identifier: Apache-2.0
// Lines on paper that run along one another.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.hpp"

namespace epura::drawing {

using Interval = std::array<double, 2>;  ///< empty if it begins beyond its end

/// Restricts an interval of u to where min <= value + u slope <= max.
inline void limit(Interval& range, double value, double slope, double min, double max) {
  if (slope == 0) {
    if (value < min || value > max) range = {1, 0};
    return;
  }
  const double a = (min - value) / slope, b = (max - value) / slope;
  range = {std::max(range[0], std::min(a, b)), std::min(range[1], std::max(a, b))};
}

/// A line and another one along it, measured along a direction that both roughly follow.
struct Beside {
  Interval range{1, 0};         ///< the part of the line, 0 at its start, that lies within the distance of the other
                                ///< line
  double value = 0, slope = 0;  ///< distance to the left of the other line, as a function of the position on the line:
                                ///< value + u slope

  /// The line begins at the origin and ends at `step`. A line steeper than `steepest` does not run along.
  Beside(const Vec2& along, const Vec2& step, const std::array<Vec2, 2>& line, double distance, double steepest) {
    const auto turned = [&](const Vec2& d) { return Vec2(glm::dot(along, d), cross(along, d)); };
    const Vec2 own = turned(step), from = turned(line[0]), other = turned(line[1]) - from;
    if (std::abs(other.y) > steepest * std::abs(other.x)) return;
    const double begin = std::min(from.x, from.x + other.x), end = std::max(from.x, from.x + other.x);
    if (end <= std::min(own.x, 0.0) || begin >= std::max(own.x, 0.0)) return;
    const double rise = other.y / other.x;
    value = rise * from.x - from.y;
    slope = own.y - rise * own.x;
    // Most lines can be excluded early.
    if (value > distance && distance - value <= slope) return;
    if (value < -distance && -distance - value >= slope) return;
    range = {0, 1};
    limit(range, 0, own.x, begin, end);
    limit(range, value, slope, -distance, distance);
  }
};

}  // namespace epura::drawing
