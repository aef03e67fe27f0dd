// SPDX-License-Identifier: Apache-2.0
// Stages that are left out where a certificate says that the drawing is the same without them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace epura {

/// Which certificates are used. Tests and measurements take them away: every drawing stays the same, to the byte.
struct LeaveOut {
  bool clip = true;           ///< by planes that have everything inside (view/view.hpp)
  bool intersections = true;  ///< of bodies that are convex and stand alone (edges/suspects.hpp)
  bool visibility = true;     ///< of a surface that the page shows as one sheet (visibility/one_sheet.hpp)
  bool hidden = true;         ///< lines that are not drawn are not made (drawing/make_drawing.hpp)
  bool text = true;           ///< without texts no font is opened

  bool operator==(const LeaveOut&) const = default;
};

/// By the names of their stages in the plan.
const std::vector<std::pair<std::string, bool LeaveOut::*>>& certificates();

/// "all", "none", or names with commas. Throws Error{input}.
LeaveOut parse_leave_out(const std::string& text);

}  // namespace epura
