// SPDX-License-Identifier: Apache-2.0
// Broken-out (local) sections: an area of a view in which the models are cut. ISO 128-3.
#pragma once

#include <span>

#include "base/progress.hpp"
#include "drawing/closed_line.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Inside a closed line, replaces a parallel view by a section seen in the same way, whose hidden lines are left out;
/// outside it, nothing changes. The line is drawn where `removed`, what is in front of the cutting plane, covers it,
/// but not over bodies that are left whole. The lines of broken-out sections of a view must not overlap. Chains the
/// lines anew, without curves. Throws OutOfTime.
void break_out(ViewDrawing& drawing, ViewDrawing section, const ClosedLine& line,
               std::span<const PaperTriangle> removed, const Progress& progress = {});

}  // namespace epura::drawing
