// SPDX-License-Identifier: Apache-2.0
// Where a view shows material that is cut: hatching, through which no leader goes if it can come from outside.
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/rectangle.hpp"

namespace epura::sheet {

class HatchedAreas {
 public:
  explicit HatchedAreas(const drawing::ViewDrawing& drawing);

  [[nodiscard]] bool contains(const Vec2& p) const;
  /// How many parts of a straight line are in hatching.
  [[nodiscard]] int on_way(const Vec2& from, const Vec2& to) const;

 private:
  struct Ring {
    Rectangle box;
    std::vector<Vec2> corners;
  };
  std::vector<Ring> rings_;  ///< of faces that do not overlap: even-odd
};

}  // namespace epura::sheet
