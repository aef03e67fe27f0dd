// SPDX-License-Identifier: Apache-2.0
// Whether a view shows the circle that a dimension measures.
#pragma once

#include "dimensions/measure.hpp"
#include "drawing/drawing.hpp"

namespace epura::sheet {

/// Whether the drawing has a line along a circle, or, if the circle is seen edge-on, a line that begins or passes at an
/// end of its diameter and leads away from the plane of the circle. A section between holes has none, and nor has a
/// view without hidden lines of what is behind its faces.
bool shows_circle(const drawing::ViewDrawing& drawing, const MeasuredDimension& measured);

/// Whether the drawing has a visible line along a circle.
bool shows_visible(const drawing::ViewDrawing& drawing, const MeasuredCircle& circle);

}  // namespace epura::sheet
