// SPDX-License-Identifier: Apache-2.0
// The holes of a view in a table, instead of a dimension for each: label, position from a marked corner, size.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drawing/view_drawing.hpp"
#include "features/part_features.hpp"
#include "sheet/marks.hpp"
#include "sheet/notation.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/table_drawing.hpp"

namespace epura::sheet {

struct HoleRow {
  std::string label, x, y, size;  ///< "A1", "10", "20", "⌀8 ↧20"
};

struct HoleTable {
  std::string view;
  Vec3 origin;  ///< from which positions are measured, in the world
  std::vector<HoleRow> rows;
};

/// What follows the diameter or thread of a hole: depth, counterbore, countersink. Empty for a plain through hole.
std::string recesses_of(const features::HoleFeature& hole, const Notation& notation);

/// Letters for groups of equal holes: A to Z without I, O and Q, which look like numbers, then AA, AB ...
std::string letters_of(std::size_t group);

/// The table with these captions of its columns.
TextTable text_table(const HoleTable& table, const std::vector<std::string>& captions);

/// Marks the origin: a circle, and arrows along X and Y.
void draw_origin(Layer& layer, const HoleTable& table, const drawing::ViewDrawing& drawing,
                 const DimensionStyle& style);

/// The upper right corner for a table of this size in the free part of `room`, 3 mm from everything that is taken; the
/// highest, then the rightmost. Nothing if there is none.
std::optional<Vec2> free_corner(const Rectangle& room, std::span<const Rectangle> taken, const Vec2& size);

}  // namespace epura::sheet
