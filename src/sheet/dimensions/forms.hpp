// SPDX-License-Identifier: Apache-2.0
// Possible placements of one dimension.
#pragma once

#include <string>
#include <vector>

#include "sheet/dimensions/marks.hpp"
#include "sheet/dimensions/measure.hpp"

namespace epura::sheet {

/// One of the placements, and what speaks against it for itself alone: the less the better.
struct DimensionPlacement {
  PlacedDimension dimension;
  double cost;
};

/// Beside the outline: on either side, further and further out, the text in the middle or moved. With an offset:
/// there, upwards or to the right where it is positive.
std::vector<DimensionPlacement> placements_of(const MeasuredLength& length, const MeasuredDimension& measured,
                                              const drawing::ViewDrawing& drawing, const DimensionStyle& style);

/// Arcs of growing radius; an offset is the radius.
std::vector<DimensionPlacement> placements_of(const MeasuredAngle& angle, const MeasuredDimension& measured,
                                              const drawing::ViewDrawing& drawing, const DimensionStyle& style);

/// Leaders to the circle, from outside or for radii also from inside; across the circle where there is room. An
/// offset is the length of the leader, negative to the inside.
std::vector<DimensionPlacement> placements_of(const MeasuredCircle& circle, const MeasuredDimension& measured,
                                              const drawing::ViewDrawing& drawing, const DimensionStyle& style);

}  // namespace epura::sheet
