// SPDX-License-Identifier: Apache-2.0
// How dense the lines of a drawing are.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "search/line_cells.hpp"

namespace epura::sheet {

/// Millimetres of line, without tangent and smooth edges, on each square millimetre of paper, in cells of equal size.
class InkDensity {
 public:
  /// Throws OutOfTime.
  InkDensity(std::span<const drawing::Chain> chains, double cell_side, const Progress& progress = {});

  /// The mean along a chain.
  [[nodiscard]] double along(const drawing::Chain& chain) const;

 private:
  search::CellGrid grid_;
  std::vector<std::int64_t> ink_;  ///< by cell, nm: whole numbers add up to the same in any order
};

}  // namespace epura::sheet
