// SPDX-License-Identifier: Apache-2.0
// A straight dimension line with its extension lines.
#pragma once

#include <string>

#include "sheet/dimensions/marks.hpp"
#include "sheet/dimensions/measure.hpp"

namespace epura::sheet {

/// Positions of the text by number: 0 is the middle, or beyond the right or upper end if it does not fit between the
/// extension lines.
inline constexpr int text_places = 5;

/// The dimension line is `distance` to the left of `length.along`, measured from `length.from`. Arrows point outwards
/// if there is room for them. A text that fits has 5 possible positions, otherwise 2.
PlacedDimension straight_dimension(const MeasuredLength& length, const DimensionText& text, double distance, int place,
                                   const DimensionStyle& style);

/// Whether the text fits above the dimension line.
bool fits_inside(const MeasuredLength& length, const DimensionText& text, const DimensionStyle& style);

}  // namespace epura::sheet
