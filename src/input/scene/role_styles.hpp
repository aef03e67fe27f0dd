// SPDX-License-Identifier: Apache-2.0
// Style files: colours, widths and dashes of line roles, for plotters and presentations.
#pragma once

#include <optional>
#include <vector>

#include "base/colour.hpp"
#include "scene/description.hpp"
#include "scene/line_roles.hpp"

namespace epura::scene {

/// How the lines of a role are drawn, as far as it differs from ISO 128-2.
struct RoleStyle {
  SheetLine line;
  std::optional<double> width{};  ///< mm
  std::optional<Colour> colour{};
  std::optional<DashType> dashes{};
};

/// Reads a TOML file with a table for each role: [visible] width = 0.7, colour = "#036", dashes = "dashed". [all] is
/// for all roles that have no value of their own. Throws Error{input} with the line for anything else.
std::vector<RoleStyle> read_role_styles(const LocatedText& file);

}  // namespace epura::scene
