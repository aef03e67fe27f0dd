// SPDX-License-Identifier: Apache-2.0
// The pixels along an edge: one per column, or one per row if it is steep.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vec.hpp"

namespace epura::study {

class PixelWalk {
 public:
  /// Ends in pixels, from the corner of the first pixel. An edge that passes no pixel centre takes one step.
  PixelWalk(const Vec2& p, const Vec2& q)
      : p_(p), along_(q - p), axis_(std::abs(along_.x) >= std::abs(along_.y) ? 0 : 1) {
    const double first = std::ceil(std::min(p[axis_], q[axis_]) - 0.5);
    const double last = std::floor(std::max(p[axis_], q[axis_]) - 0.5);
    if (first <= last) {
      first_ = static_cast<int>(first);
      steps_ = static_cast<int>(last - first) + 1;
    }
  }

  [[nodiscard]] int steps() const { return std::max(steps_, 1); }

  /// Page parameter of a step.
  [[nodiscard]] double position(int step) const { return steps_ == 0 ? 0.5 : at(step_column(step) + 0.5); }

  [[nodiscard]] std::array<int, 2> pixel(int step) const {
    const Vec2 point = p_ + position(step) * along_;
    std::array<int, 2> pixel{whole(point.x), whole(point.y)};
    if (steps_ > 0) pixel[static_cast<std::size_t>(axis_)] = std::max(step_column(step), 0);
    return pixel;
  }

  /// The part of the edge that a step represents. The first and the last step extend to its ends.
  [[nodiscard]] std::array<double, 2> part(int step) const {
    return {step == 0 ? 0 : at(step_edge(step)), step + 1 == steps() ? 1 : at(step_edge(step + 1))};
  }

 private:
  static int whole(double x) { return static_cast<int>(std::max(std::floor(x), 0.0)); }
  // Steps run from the first end to the second.
  [[nodiscard]] int step_column(int step) const {
    return along_[axis_] < 0 ? first_ + steps_ - 1 - step : first_ + step;
  }
  // The border between the columns of the previous step and this one.
  [[nodiscard]] double step_edge(int step) const {
    return along_[axis_] < 0 ? step_column(step) + 1.0 : double(step_column(step));
  }
  [[nodiscard]] double at(double column) const { return std::clamp((column - p_[axis_]) / along_[axis_], 0.0, 1.0); }

  Vec2 p_, along_;
  int axis_;
  int first_ = 0, steps_ = 0;
};

}  // namespace epura::study
