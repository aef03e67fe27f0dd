// SPDX-License-Identifier: Apache-2.0
// Upright rectangles on a sheet, mm.
#pragma once

#include "base/vec.hpp"

namespace epura {

struct Rectangle {
  Vec2 least, most;

  [[nodiscard]] Vec2 size() const { return most - least; }
  [[nodiscard]] Vec2 centre() const { return least / 2.0 + most / 2.0; }
  [[nodiscard]] Rectangle grown(double by) const { return {least - by, most + by}; }

  /// Whether they share more than `slack` mm both ways; touching is none.
  [[nodiscard]] bool overlaps(const Rectangle& other, double slack = 0) const {
    const Vec2 shared = glm::min(most, other.most) - glm::max(least, other.least);
    return shared.x > slack && shared.y > slack;
  }
  [[nodiscard]] bool holds(const Rectangle& other, double slack = 0) const {
    return other.least.x >= least.x - slack && other.least.y >= least.y - slack && other.most.x <= most.x + slack &&
           other.most.y <= most.y + slack;
  }
};

/// The smallest one that holds both.
inline Rectangle united(const Rectangle& a, const Rectangle& b) {
  return {glm::min(a.least, b.least), glm::max(a.most, b.most)};
}

}  // namespace epura
