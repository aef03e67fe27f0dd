// SPDX-License-Identifier: Apache-2.0
// Estimates how many digits a drawing can have: the effect of rounding the input to doubles on positions on the page.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "projection/projection.hpp"

namespace epura::view {

/// Relative componentwise condition number of a map (Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed.,
/// 1.6): if every number of the input (coordinates, plane, projector, window) has the relative change e, positions on
/// the page change by at most about `number` e, as a fraction of the drawing's size. Changes that move the whole
/// drawing equally do not count, unless a window fixes its position.
struct Condition {
  double number = 1;  ///< at least 1
  std::string why;    ///< what contributes most to it, as half a sentence
  /// How far positions move when coordinates are rounded to the precision of the files (32-bit floats or decimals), as
  /// a fraction of the drawing's size. 0 if the files have doubles.
  double moved_by_files = 0;

  [[nodiscard]] double digits_lost() const { return std::log10(number); }
  /// Of the 16 (15.95) digits that doubles have, or of those that the files have.
  [[nodiscard]] double digits_left() const {
    return std::max(0.0, std::min(53 * std::log10(2.0) - digits_lost(), -std::log10(moved_by_files)));
  }
};

/// Number of lost digits from which a warning is given.
inline constexpr double too_many_lost_digits = 8;
/// A warning is also given if files leave fewer digits than this, since lines begin to move visibly.
inline constexpr double fewest_digits_of_files = 4;

/// `scene` is the box of everything that is drawn; `one_rounding` is the effect of rounding on its coordinates (World).
Condition condition_of(const projection::Projection& projection, const Box& scene, const Vec3& one_rounding = Vec3(0));

}  // namespace epura::view
