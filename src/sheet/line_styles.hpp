// SPDX-License-Identifier: Apache-2.0
// Appearance of the roles in scene/line_roles.hpp on a sheet of a given size.
#pragma once

#include <string>

#include "scene/line_roles.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Widths of lines that follow the sheet, mm: 0.7 and 0.35 from A1 on, 0.5 and 0.25 below.
struct LineWidths {
  double wide, narrow;
};
LineWidths line_widths(const Paper& paper);

/// The pattern for lines of this width, not fitted to any.
Dashes nominal_dashes(const scene::DashType& type, double width);

LineStyle line_style(scene::SheetLine line, const LineWidths& widths);

/// Layer "VIEW/...", without ink.
Layer empty_layer(const std::string& view, scene::SheetLine line, const LineWidths& widths);

}  // namespace epura::sheet
