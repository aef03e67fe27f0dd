// SPDX-License-Identifier: Apache-2.0
// Dimensions of a view. ISO 129-1.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "dimensions/conflicts.hpp"
#include "dimensions/place_items.hpp"
#include "drawing/view_drawing.hpp"
#include "scene/description.hpp"
#include "sheet/marks.hpp"
#include "sheet/sheet.hpp"
#include "world/world.hpp"

namespace epura::sheet {

/// Something else that stands at a view, and is placed with its dimensions.
struct ItemBeside {
  PlacementItem item;
  std::string dimension{};  ///< name of the one at which it stands; empty: none
};

/// A view in its final position, and the dimensions of it.
struct DimensionedView {
  const world::World& world;
  const drawing::ViewDrawing& drawing;
  std::span<const scene::DimensionDescription> dimensions;
  std::size_t found = 0;     ///< how many of them, the first ones, nobody asked for: they are left out without room
  bool lacks_lines = false;  ///< since time was over
  /// By dimension, if there are any: circles of equal features, at which it may stand instead: "4× ⌀8"; of a length,
  /// circles of what it is the place of, one of which must be seen.
  std::span<const std::vector<scene::FeatureCircle>> equal{};
  std::span<const ItemBeside> beside{};
  bool is_turned = false;  ///< whether parts of the world are elsewhere in it, as in aligned sections
};

/// The dimensions of a view on paper.
struct PlacedLayer {
  Layer layer;
  std::vector<TurnedBox> zones{};                           ///< of its dimensions, for their exclusive use
  std::size_t count = 0;                                    ///< of the dimensions for which there was time
  std::vector<std::size_t> left_out{};                      ///< numbers of those without room
  std::vector<std::pair<std::size_t, TurnedBox>> places{};  ///< numbers of those that are drawn, and their texts
  std::vector<std::string> texts_left_out{};
  std::vector<std::size_t> unseen{};  ///< numbers of those that measure what the view does not show, also left out
  std::vector<std::string> texts_unseen{};
  std::vector<std::string> fans{};  ///< texts of rows that are too many for a side of the view, or longer than it
  bool has_conflicts = false;       ///< whether something has a place where it meets something else
  /// Ends of the dimension lines that have a name; arrows are numbers of areas of the layer.
  std::map<std::string, std::vector<DimensionEnd>> ends{};
  PlacedDimensions beside{};  ///< what is placed with them

  /// Numbers of those of `wanted` dimensions that are not drawn: unseen, without room, or without time.
  [[nodiscard]] std::vector<std::size_t> undrawn(std::size_t wanted) const {
    std::vector<std::size_t> numbers = unseen;
    numbers.insert(numbers.end(), left_out.begin(), left_out.end());
    for (std::size_t number = count; number < wanted; ++number) numbers.push_back(number);
    return numbers;
  }
};

/// Layer "VIEW/dimensions" of a drawing in its final position: narrow lines, filled arrows, and texts. Values are the
/// true measures in the world. Dimensions are outside the outline, small ones inside large ones, and avoid each other
/// and their neighbours as far as possible; an offset is obeyed. Dimensions for which there is no
/// time are omitted. Of those that were found, circles that the view does not show are left out, and of these and of
/// what is required as many as it takes that no text is on anything else, no line is in another view and none is beyond
/// the sheet. Throws
/// Error{input}: see sizes/anchors.hpp and measure.hpp; also for characters missing from the font.
PlacedLayer place_dimensions(const DimensionedView& view, const DimensionStyle& style,
                             const Neighbours& neighbours = {}, const Progress& progress = {});

/// Whether all of it lies on paper of this size, mm.
bool on_paper(const Layer& dimensions, const Vec2& size);

}  // namespace epura::sheet
