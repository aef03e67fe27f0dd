// SPDX-License-Identifier: Apache-2.0
// The lines that limit interrupted, partial and half views, and those of exploded views. ISO 128-2, ISO 128-3.
#pragma once

#include <optional>

#include "drawing/drawing.hpp"
#include "sheet/sheet.hpp"
#include "sheet/view_lines.hpp"

namespace epura::sheet {

/// Layer VIEW/limit: break lines with zigzags (type 01.1.19) past the outline, or freehand lines up to it, and the
/// graphical symbol for symmetry, two short parallel lines at either end of a line of symmetry; freehand lines (type
/// 01.1) around broken-out sections. All are narrow and continuous. Nothing if the view is complete.
std::optional<Layer> limit_lines(const drawing::ViewDrawing& view, const LineWidths& widths);

/// Adds the lines of symmetry of half views: long-dashed dotted narrow lines (04.1), which replace centre lines of the
/// layer in the same places.
void add_symmetry_lines(Layer& centre, const drawing::ViewDrawing& view, const LineWidths& widths);

/// Layer VIEW/revolved: outlines of revolved sections, narrow and continuous (type 01.1), and the axes about which they
/// are turned, long-dashed dotted and narrow. Nothing if there are none.
std::optional<Layer> revolved_lines(const drawing::ViewDrawing& view, const LineWidths& widths);

/// Layer VIEW/trace: long-dashed dotted narrow lines from the places of moved bodies. Nothing if there are none.
std::optional<Layer> trace_lines(const drawing::ViewDrawing& view, const LineWidths& widths);

/// How far these lines extend past the outline, mm.
double limit_room(const LineWidths& widths);

}  // namespace epura::sheet
