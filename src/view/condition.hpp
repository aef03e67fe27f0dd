// How many digits a drawing can have: what the rounding of its input to doubles does to places on the page.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "projection/projection.hpp"

namespace epura {

/// Relative condition number of a map, component by component (Higham, Accuracy and Stability of Numerical Algorithms,
/// 2nd ed., 1.6): when every number of the input (coordinates, plane, projector, window) changes by the part e of
/// itself, places on the page change by at most about `number` e, in parts of the drawing's size. Changes that move
/// the whole drawing alike do not count, unless a window says where it is to stand.
struct Condition {
  double number = 1;  ///< at least 1
  std::string why;    ///< what most of it comes from, as half a sentence

  [[nodiscard]] double digits_lost() const { return std::log10(number); }
  /// Of the 16 (15.95) that doubles have.
  [[nodiscard]] double digits_left() const { return std::max(0.0, 53 * std::log10(2.0) - digits_lost()); }
};

/// From so many lost digits on, the drawing says so.
inline constexpr double too_many_lost_digits = 8;

/// `scene` is the box of everything that is drawn.
Condition condition_of(const Projection& projection, const Box& scene);

}  // namespace epura
