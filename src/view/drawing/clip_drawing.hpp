// SPDX-License-Identifier: Apache-2.0
// The part of a drawing inside a boundary, as in detail views, or inside or outside a closed line, and drawings of two
// such parts: broken-out (local) sections.
#pragma once

#include <span>

#include "base/progress.hpp"
#include "drawing/closed_line.hpp"
#include "drawing/drawing.hpp"

namespace epura::drawing {

/// Cuts the lines and cut faces of a parallel view off at a boundary, exactly.
void clip_to(ViewDrawing& drawing, const Boundary& boundary);

/// Leaves what lies inside a closed line, exactly.
void clip_to(ViewDrawing& drawing, const ClosedLine& line);

/// Leaves the lines outside a closed line, exactly; cut faces remain.
void clip_lines_outside(ViewDrawing& drawing, const ClosedLine& line);

/// Appends the lines, cut faces and what is before them.
void append_part(ViewDrawing& drawing, ViewDrawing part);

/// Cuts the lines and cut faces of a parallel view off at the boundary of its detail, exactly, and chains the lines
/// anew, without curves. The box of its ink becomes that of the boundary. Throws OutOfTime.
void clip_drawing(ViewDrawing& drawing, const DetailFrame& detail, const Progress& progress = {});

/// Breaks out a section, ISO 128-3: inside a closed line, replaces a parallel view by a section seen in the same way,
/// whose hidden lines are left out; outside it, nothing changes. The line is drawn where `removed`, what is in front of
/// the cutting plane, covers it, but not over bodies that are left whole. The lines of broken-out sections of a view
/// must not overlap. Chains the lines anew, without curves. Throws OutOfTime.
void break_out(ViewDrawing& drawing, ViewDrawing section, const ClosedLine& line,
               std::span<const PaperTriangle> removed, const Progress& progress = {});

}  // namespace epura::drawing
