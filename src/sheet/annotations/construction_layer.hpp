// SPDX-License-Identifier: Apache-2.0
// Construction lines on a sheet: cut off where its room ends, with arrows to points beyond it, and symbols clear of
// lines. Narrow continuous lines, ISO 128-2 type 01.1.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "construction/figure.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/marks.hpp"
#include "sheet/rectangle.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Where constructions may be.
struct ConstructionRoom {
  Rectangle area;                                    ///< lines end at its border
  std::vector<TurnedBox> taken{};                    ///< lettering and marks, which symbols avoid
  std::vector<const drawing::ViewDrawing*> views{};  ///< whose lines they avoid
  std::optional<Rectangle> labels{};                 ///< where symbols may be; by default in the area
};

/// Layer "VIEW/construction". Figures beside the view and symbols that have no place in the room are left out, and
/// told.
struct ConstructionLayer {
  Layer layer;
  std::size_t without_place = 0;
  std::vector<std::string> unnamed{};  ///< symbols for which there is no place
  std::vector<Rectangle> keys{};       ///< where the figures beside the view are
};
ConstructionLayer construction_layer(const std::string& view, const construction::Figure& figure,
                                     const ConstructionRoom& room, const DimensionStyle& style);

/// Room beside a view for its figures of constant size, mm.
double construction_room(const construction::Figure& figure);

/// The rectangle around the points of a figure, the ends of its lines and its curves, without those that are farther
/// than `farthest` from the centre of `ink`.
Rectangle box_of(const construction::Figure& figure, const Rectangle& ink, double farthest);

/// The part of a line in the area.
std::optional<std::array<Vec2, 2>> clipped(const construction::Line& line, const Rectangle& area);

/// "512 mm", "1.25 m", "1000000 km"
std::string distance_text(double millimetres);

}  // namespace epura::sheet
