// SPDX-License-Identifier: Apache-2.0
// Appearance of the roles in scene/line_roles.hpp on a sheet of a given size.
#pragma once

#include <string>
#include <vector>

#include "scene/line_roles.hpp"
#include "scene/role_styles.hpp"
#include "sheet/paper.hpp"
#include "sheet/sheet.hpp"

namespace epura::sheet {

/// Line widths by sheet size, mm: 0.7 and 0.35 from A1, 0.5 and 0.25 below.
struct LineWidths {
  double wide, narrow;
  std::vector<scene::RoleStyle> styles{};  ///< of single roles, instead
};
LineWidths line_widths(const Paper& paper, std::vector<scene::RoleStyle> styles = {});

/// The pattern of a line of this width, not fitted to a length.
Dashes nominal_dashes(const scene::DashType& type, double width);

/// The line type of a role, in widths of its lines.
scene::DashType dash_type(scene::SheetLine line, const LineWidths& widths);

double line_width(scene::SheetLine line, const LineWidths& widths);

LineStyle line_style(scene::SheetLine line, const LineWidths& widths);

/// Gives layers what a style file says of their roles, also those that were made without knowing it. Colours of bodies
/// stay.
void restyle(std::vector<Layer>& layers, const LineWidths& widths);

/// Layer "VIEW/...", without ink.
Layer empty_layer(const std::string& view, scene::SheetLine line, const LineWidths& widths);

}  // namespace epura::sheet
