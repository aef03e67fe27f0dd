// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

namespace epura {

/// From the least to the greatest of some numbers; empty at first.
struct Range {
  double from = HUGE_VAL, to = -HUGE_VAL;

  void add(double value) {
    from = std::min(from, value);
    to = std::max(to, value);
  }
  void add(const Range& other) {
    from = std::min(from, other.from);
    to = std::max(to, other.to);
  }
  [[nodiscard]] double size() const { return to - from; }
  [[nodiscard]] double middle() const { return (from + to) / 2; }
};

}  // namespace epura
