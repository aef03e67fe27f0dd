// SPDX-License-Identifier: Apache-2.0
// Possible placements of one dimension.
#pragma once

#include <string>
#include <vector>

#include "dimensions/measure.hpp"
#include "dimensions/place_items.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/marks.hpp"

namespace epura::sheet {

/// Beside the outline: on either side, further and further out, with the text in the middle or shifted. With an offset:
/// only there, upwards or to the right if it is positive.
std::vector<ItemPlacement> placements_of(const MeasuredLength& length, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style);

/// The same for a row of lengths.
std::vector<ItemPlacement> placements_of(const MeasuredRow& row, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style);

/// Whether a row with a common origin has too many places for one side of a view, or texts that need more than so many
/// mm along it.
bool is_fan(const MeasuredRow& row, double room, const DimensionStyle& style);

/// A row with a common origin; if it would be a fan beside its own length, two such rows on opposite sides, each with
/// the places nearer to it.
std::vector<MeasuredRow> on_two_sides(const MeasuredRow& row, const DimensionStyle& style);

/// Arcs of growing radius; an offset is the radius. Of the length of an arc: arcs farther and farther outside it; an
/// offset is the distance.
std::vector<ItemPlacement> placements_of(const MeasuredAngle& angle, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style);

/// Leaders to the circle from outside, and for radii also from inside; across the circle if there is room. An offset is
/// the length of the leader, negative towards the inside.
std::vector<ItemPlacement> placements_of(const MeasuredCircle& circle, const MeasuredDimension& measured,
                                         const drawing::ViewDrawing& drawing, const DimensionStyle& style);

/// More placements, which are less usual: of a length, the text farther out beside it, or on a leader to its dimension
/// line; of a circle, leaders in more directions, and longer ones. None if there is an offset.
std::vector<ItemPlacement> placements_in_crowd(const MeasuredLength& length, const MeasuredDimension& measured,
                                               const drawing::ViewDrawing& drawing, const DimensionStyle& style);
std::vector<ItemPlacement> placements_in_crowd(const MeasuredCircle& circle, const MeasuredDimension& measured,
                                               const drawing::ViewDrawing& drawing, const DimensionStyle& style);

}  // namespace epura::sheet
