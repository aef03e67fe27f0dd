// SPDX-License-Identifier: Apache-2.0
// A straight dimension line with its extension lines.
#pragma once

#include "dimensions/measure.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

/// Positions of the text by number: 0 is the middle, or beyond the right or upper end if it does not fit between the
/// extension lines.
inline constexpr int text_places = 5;

/// The dimension line is `distance` to the left of `length.along`, measured from `length.from`. Arrows point outwards
/// if there is room for them. A text that fits has 5 possible positions, otherwise 2.
PlacedDimension straight_dimension(const MeasuredLength& length, const DimensionText& text, double distance, int place,
                                   const DimensionStyle& style);

/// A text beside the extension lines, at the right or upper end of the dimension line or at the other one; the line
/// reaches to it. How much farther out than usual.
struct TextBeside {
  bool at_high;
  double farther;
};
PlacedDimension straight_dimension_beside(const MeasuredLength& length, const DimensionText& text, double distance,
                                          const TextBeside& beside, const DimensionStyle& style);

/// The same with the text on a leader that begins in the middle of the dimension line. ISO 129-1.
PlacedDimension straight_dimension_with_leader(const MeasuredLength& length, const DimensionText& text, double distance,
                                               const Vec2& leader, const DimensionStyle& style);

/// The part of a dimension line between two extension lines; `read` points from its lower or left end to the other one.
/// An open end has no arrow.
struct DimensionLine {
  Vec2 low, high, read;
  double span;
  bool low_open = false, high_open = false;
  double lean = 0;  ///< of the extension lines, along `read` for each millimetre to its left
};

/// Adds it with arrows and a text, which may need more of the line outside.
void add_dimension_line(PlacedDimension& dimension, const DimensionLine& line, const DimensionText& text, int place,
                        const DimensionStyle& style);

/// Adds an extension line from an anchor to beyond a dimension line, unless they are at one place.
void add_extension_line(PlacedDimension& dimension, const Vec2& anchor, const Vec2& foot, const DimensionStyle& style);

/// Arrows point outwards in spans of this many of their lengths, and inwards in shorter ones.
inline constexpr double arrows_inside = 3;

/// Whether the text fits above the dimension line.
bool fits_inside(const MeasuredLength& length, const DimensionText& text, const DimensionStyle& style);

}  // namespace epura::sheet
