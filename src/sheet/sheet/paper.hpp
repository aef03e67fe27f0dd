// SPDX-License-Identifier: Apache-2.0
// Paper sizes, drawing areas and scales. Sizes: ISO 216; drawing area: ISO 5457 (20 mm on the left, 10 mm elsewhere).
// Sizes in inches and their drawing areas: ASME Y14.1-2020, table 1.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/vec.hpp"
#include "scene/choices.hpp"
#include "sheet/rectangle.hpp"

namespace epura::sheet {

/// Millimetres. Width 0: the paper is cut to the drawing.
struct Paper {
  double width = 0, height = 0;
  double left = 5, other = 5;       ///< margins: `other` on the right, and at the top and bottom without `ends`
  std::optional<double> ends{};     ///< margin at the top and bottom if it differs
  std::optional<Rectangle> area{};  ///< for drawings, instead of what is within the margins

  [[nodiscard]] double above() const { return ends.value_or(other); }  ///< and below
};

/// What ASME Y14.1 says of one of its sizes. Zones: the numbers of fields along the longer and the shorter side.
struct AnsiSheet {
  double longer, shorter;       ///< mm
  double at_ends, along_sides;  ///< margins, mm: at the shorter sides, along the longer ones
  int long_zones, short_zones;  ///< 0: none
};

/// The size A to E that this paper has, with its margins, or null.
const AnsiSheet* ansi_sheet(const Paper& paper);

/// The size of paper of this width and height: an A size if it is one within 0.1 mm, whatever its orientation.
scene::PaperChoice paper_of_size(const Vec2& size);

/// A to E as "A", "B" ...; A0 to A4 as "A0" ...; sizes of custom paper as "300x200"; otherwise "none".
std::string size_name(const scene::PaperChoice& size);

/// A sizes are landscape unless `portrait`. An automatic size gives an empty Paper.
Paper make_paper(const scene::PaperChoice& size, bool portrait);

/// "A3" for a sheet of that size, landscape or portrait; otherwise "300x200"; empty for paper that is cut to the
/// drawing.
std::string paper_name(const Paper& paper);

/// The paper within its margins.
Rectangle drawing_area(const Paper& paper);

/// Position of a drawing: page = scale * plane + shift.
struct Placement {
  Paper paper;  ///< with its final size
  double scale;
  Vec2 shift;
  bool inside;  ///< the ink is within the margins
};

/// Throws Error{input} for a drawing beyond `longest_side`.
void check_drawing_size(const Vec2& size);

/// Centres the ink with the box `min` to `max` in the projection plane in the drawing area. Without a scale, it is made
/// as large as fits; without paper, as large as fits on A4. Throws Error{input} beyond `longest_side`.
Placement place_ink(const Vec2& min, const Vec2& max, std::optional<double> scale, const Paper& paper);

}  // namespace epura::sheet
