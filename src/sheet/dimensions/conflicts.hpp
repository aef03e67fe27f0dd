// SPDX-License-Identifier: Apache-2.0
// Dimensions that cannot be read where they are, because something else is there.
#pragma once

#include <optional>
#include <vector>

#include "sheet/marks.hpp"
#include "sheet/rectangle.hpp"

namespace epura::sheet {

/// Items on the sheet near a view.
struct Neighbours {
  std::optional<Rectangle> paper{};  ///< limits for everything
  std::vector<TurnedBox> boxes{};    ///< of other views, lettering, marks ...
  std::vector<TurnedBox> views{};  ///< those of other views, and blocks of the sheet, in which nothing of this view is
  std::vector<TurnedBox> texts{};  ///< those of lettering alone, through which no line goes
  std::vector<TurnedBox> zones{};  ///< of dimensions of other views, in which no text of this one is
  std::vector<TurnedBox> letters{};  ///< of marks at the view itself: lines that cannot avoid them are interrupted
};

/// Whether a dimension line or text shares its place with the other dimension, or a line of the other one crosses it.
bool do_cross(const PlacedDimension& a, const PlacedDimension& b);

/// Whether leaders of both cross.
bool have_crossing_leaders(const PlacedDimension& a, const PlacedDimension& b);

/// By item of a view; nothing for those that are not drawn.
using PlacedDimensions = std::vector<std::optional<PlacedDimension>>;

}  // namespace epura::sheet
