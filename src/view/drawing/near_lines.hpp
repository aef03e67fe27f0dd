// SPDX-License-Identifier: Apache-2.0
// How close lines are one line to a person, and which of them is drawn (drawing/near_ink.hpp).
#pragma once

#include <functional>
#include <numbers>

#include "edges/edge_kind.hpp"

namespace epura::drawing {

struct NearLines {
  double distance = 0;  ///< mm on paper; 0: all lines are drawn
  /// For model, body, kind and visibility: of two lines, the one with the greater number is drawn; a negative number
  /// means no ink.
  std::function<int(int, int, EdgeKind, bool)> strength{};

  /// For removed ink, there is ink that stays within this distance, mm.
  [[nodiscard]] double reach() const { return std::numbers::sqrt2 * distance; }
  /// The same once lines are continued and dangles are dropped, which may be the ink that stayed.
  [[nodiscard]] double reach_in_all() const { return reach() + 2.5 * distance; }
};

}  // namespace epura::drawing
