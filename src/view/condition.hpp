// SPDX-License-Identifier: Apache-2.0
// How many digits a drawing can have: the effect of rounding the input to doubles on positions on the page.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "projection/projection.hpp"

namespace epura::view {

/// Relative condition number of a map, component by component (Higham, Accuracy and Stability of Numerical Algorithms,
/// 2nd ed., 1.6): when every number of the input (coordinates, plane, projector, window) changes by the part e of
/// itself, places on the page change by at most about `number` e, in parts of the drawing's size. Changes that move
/// the whole drawing alike do not count, unless a window fixes its position.
struct Condition {
  double number = 1;  ///< at least 1
  std::string why;    ///< what most of it comes from, as half a sentence
  /// By which part of the drawing's size places move when coordinates are rounded as the files have them: to 32-bit
  /// floats or to decimals. 0 where they are doubles.
  double moved_by_files = 0;

  [[nodiscard]] double digits_lost() const { return std::log10(number); }
  /// Of the 16 (15.95) that doubles have, or of those that the files have.
  [[nodiscard]] double digits_left() const {
    return std::max(0.0, std::min(53 * std::log10(2.0) - digits_lost(), -std::log10(moved_by_files)));
  }
};

/// From this number of lost digits on, the drawing warns.
inline constexpr double too_many_lost_digits = 8;
/// So, too, where files leave fewer digits than this: that is when lines begin to move by what is seen.
inline constexpr double fewest_digits_of_files = 4;

/// `scene` is the box of everything that is drawn; `one_rounding` what a rounding of its coordinates is (World).
Condition condition_of(const projection::Projection& projection, const Box& scene, const Vec3& one_rounding = Vec3(0));

}  // namespace epura::view
