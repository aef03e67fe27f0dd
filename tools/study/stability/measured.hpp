// SPDX-License-Identifier: Apache-2.0
// Measured quantities of a drawing and their expected values.
#pragma once

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace epura::stability {

/// Lengths and positions may be off by this fraction of the drawing, which the program guarantees for its spans.
inline constexpr double guaranteed_part = 1e-6;

struct Quantity {
  std::string name;
  double expected, got;
  double scale;         ///< errors are relative to it: the size of the drawing; 1 for counts
  double allowed;       ///< error up to which it is right
  double rounding = 0;  ///< error explained by rounding the input to doubles (view/condition.hpp)

  /// Infinite if there is no comparable result.
  [[nodiscard]] double error() const {
    const double e = std::abs(got - expected) / scale;
    return std::isnan(e) ? std::numeric_limits<double>::infinity() : e;
  }
  [[nodiscard]] bool right() const { return error() <= allowed; }
  /// Not right, but no worse than the condition of the map allows.
  [[nodiscard]] bool limited() const { return !right() && error() <= rounding; }
};

using Measured = std::vector<Quantity>;

inline Quantity length(std::string name, double expected, double got, double scale, double allowed = guaranteed_part) {
  return {std::move(name), expected, got, scale, allowed};
}

inline void append(Measured& all, const Measured& more) { all.insert(all.end(), more.begin(), more.end()); }

/// Integers are right or wrong.
inline Quantity count(std::string name, double expected, double got) { return {std::move(name), expected, got, 1, 0}; }

}  // namespace epura::stability
