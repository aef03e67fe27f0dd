// SPDX-License-Identifier: Apache-2.0
// Axis-parallel rectangles on a sheet, mm.
#pragma once

#include "base/vec.hpp"

namespace epura::sheet {

struct Rectangle {
  Vec2 min, max;

  [[nodiscard]] Vec2 size() const { return max - min; }
  [[nodiscard]] Vec2 centre() const { return min / 2.0 + max / 2.0; }
  [[nodiscard]] Rectangle grown(double by) const { return {min - by, max + by}; }

  /// Whether they overlap by more than `slack` mm in both directions; touching is not overlapping.
  [[nodiscard]] bool overlaps(const Rectangle& other, double slack = 0) const {
    const Vec2 shared = glm::min(max, other.max) - glm::max(min, other.min);
    return shared.x > slack && shared.y > slack;
  }
  [[nodiscard]] bool holds(const Rectangle& other, double slack = 0) const {
    return other.min.x >= min.x - slack && other.min.y >= min.y - slack && other.max.x <= max.x + slack &&
           other.max.y <= max.y + slack;
  }
};

/// The smallest rectangle that contains both.
inline Rectangle united(const Rectangle& a, const Rectangle& b) {
  return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

}  // namespace epura::sheet
