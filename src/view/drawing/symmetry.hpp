// SPDX-License-Identifier: Apache-2.0
// Whether a drawing is symmetric, as half views require. ISO 128-3.
#pragma once

#include "base/progress.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Returns the length of the visible lines that have no visible line at their mirror image, in mm: 0 if the drawing is
/// symmetric. The mirror is the line at `at` perpendicular to an axis of the page (0: x, 1: y). Lines within `slack` mm
/// of an image count, so that different tessellations of both sides do not matter. Throws OutOfTime.
double length_without_mirror_image(const ViewDrawing& drawing, int axis, double at, double slack,
                                   const Progress& progress = {});

}  // namespace epura::drawing
