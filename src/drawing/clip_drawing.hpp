// SPDX-License-Identifier: Apache-2.0
// Detail views: the part of a drawing inside a boundary.
#pragma once

#include "base/progress.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Cuts the lines and cut faces of a parallel view off at a boundary, exactly.
void clip_to(ViewDrawing& drawing, const Boundary& boundary);

/// Cuts the lines and cut faces of a parallel view off at the boundary of its detail, exactly, and chains the lines
/// anew, without curves. The box of its ink becomes that of the boundary. Throws OutOfTime.
void clip_drawing(ViewDrawing& drawing, const DetailFrame& detail, const Progress& progress = {});

}  // namespace epura::drawing
