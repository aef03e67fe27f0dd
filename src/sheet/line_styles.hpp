// SPDX-License-Identifier: Apache-2.0
// Appearance of the roles in scene/line_roles.hpp on a sheet of a given size.
#pragma once

#include <string>

#include "scene/line_roles.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Line widths by sheet size, mm: 0.7 and 0.35 from A1, 0.5 and 0.25 below.
struct LineWidths {
  double wide, narrow;
};
LineWidths line_widths(const Paper& paper);

/// The pattern of a line of this width, not fitted to a length.
Dashes nominal_dashes(const scene::DashType& type, double width);

LineStyle line_style(scene::SheetLine line, const LineWidths& widths);

/// Layer "VIEW/...", without ink.
Layer empty_layer(const std::string& view, scene::SheetLine line, const LineWidths& widths);

}  // namespace epura::sheet
