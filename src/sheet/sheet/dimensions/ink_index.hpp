// SPDX-License-Identifier: Apache-2.0
// The lines of a view, indexed by position.
#pragma once

#include "drawing/ink_cells.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/dimensions/boxes.hpp"

namespace epura::sheet {

class InkIndex {
 public:
  explicit InkIndex(const drawing::ViewDrawing& drawing);

  /// How many lines of the drawing pass through the box, as ink_in counts them.
  [[nodiscard]] int in(const TurnedBox& box) const;

 private:
  const drawing::ViewDrawing& drawing_;
  drawing::InkCells cells_;  ///< numbers of segments
};

}  // namespace epura::sheet
