// SPDX-License-Identifier: Apache-2.0
// Dimensions that cannot be read where they are, because something else is there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"
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

/// Whether a text of the dimension is on something else on the sheet, or one of its lines goes through a text there.
bool meets(const PlacedDimension& dimension, const Neighbours& neighbours);

/// Whether a line or text of the dimension is inside another view, where it would be read as a size of that.
bool is_in_other_view(const PlacedDimension& dimension, const Neighbours& neighbours);

/// Whether a line or text is beyond the limits of the sheet.
bool is_beyond(const PlacedDimension& dimension, const Neighbours& neighbours);

/// Whether lines of the view go through a text.
bool is_on_lines(const PlacedDimension& dimension, const drawing::ViewDrawing& drawing);

/// By dimension of a view; nothing for those that are not drawn.
using PlacedDimensions = std::vector<std::optional<PlacedDimension>>;

/// How many of the four faults above a dimension has where it is placed.
int faults_of(const PlacedDimension& dimension, const drawing::ViewDrawing& drawing, const Neighbours& neighbours);

/// A sentence for each conflict but the limits of the sheet, and of a dimension with more than max_in_crowd others for
/// the first of these; `texts` are those of the dimensions.
std::vector<std::string> crossings_of(const PlacedDimensions& placed, const std::vector<std::string>& texts,
                                      const drawing::ViewDrawing& drawing, const Neighbours& neighbours);

}  // namespace epura::sheet
