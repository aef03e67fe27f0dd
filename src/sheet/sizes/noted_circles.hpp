// SPDX-License-Identifier: Apache-2.0
// Circles on which equal holes are, for "8× ⌀10 ON ⌀96 BC": no feature is asked.
#pragma once

#include <optional>
#include <vector>

#include "sizes/anchors.hpp"

namespace epura::sheet {

struct CircleOfHoles {
  WorldCircle circle;
  std::vector<double> angles;  ///< of the axes on it, radians, ascending; each axis once

  /// Whether they divide the turn evenly.
  [[nodiscard]] bool is_even() const;
};

/// Circles through the axis of a hole and axes parallel to it, of a diameter or of any, across these.
std::vector<CircleOfHoles> circles_of_holes(const WorldCircle& hole, const std::vector<WorldCircle>& equal,
                                            std::optional<double> diameter, double slack);

}  // namespace epura::sheet
