// SPDX-License-Identifier: Apache-2.0
// The areas of datum targets in views that show them true. ISO 5459, 7.2: an area is hatched within a narrow
// long-dashed double-dotted line, a line is such a line between crosses, a point is a cross.
#pragma once

#include <optional>
#include <span>

#include "annotations/callouts.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/line_styles.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Layer "VIEW/targets" for those of the callouts that have a place; nothing if there are none.
std::optional<Layer> target_areas(const drawing::ViewDrawing& view, std::span<const Callout> callouts,
                                  const CalloutFaults& placed, const LineWidths& widths);

}  // namespace epura::sheet
