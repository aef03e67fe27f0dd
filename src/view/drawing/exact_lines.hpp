// SPDX-License-Identifier: Apache-2.0
// Draws lines of recognised surfaces in place of those of their facets: circles and other arcs, contours of cylinders
// and cones, crossings.
#pragma once

#include "base/progress.hpp"
#include "drawing/arcs.hpp"
#include "drawing/drawing.hpp"
#include "world/world.hpp"

namespace epura::drawing {

/// Finds the curves of a drawing of the world, moves contours, crossings and ends of lines onto the surfaces, and
/// widens the box of the ink. In central projections, only curves are found. Throws OutOfTime.
CurveReport draw_exactly(const world::World& world, ViewDrawing& drawing, CurveLimits limits,
                         const Progress& progress = {});

}  // namespace epura::drawing
