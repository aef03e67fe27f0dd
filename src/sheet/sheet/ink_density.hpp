// SPDX-License-Identifier: Apache-2.0
// The density of the lines of a drawing.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "search/line_cells.hpp"

namespace epura::sheet {

/// Millimetres of line per square millimetre of paper, without tangent and smooth edges, in cells of equal size.
class InkDensity {
 public:
  /// Throws OutOfTime.
  InkDensity(std::span<const drawing::Chain> chains, double cell_side, const Progress& progress = {});

  /// The mean along a chain.
  [[nodiscard]] double along(const drawing::Chain& chain) const;

 private:
  search::CellGrid grid_;
  std::vector<std::int64_t> ink_;  ///< by cell, nm: sums of integers do not depend on their order
};

}  // namespace epura::sheet
