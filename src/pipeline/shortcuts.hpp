// SPDX-License-Identifier: Apache-2.0
// Stages that are skipped if a test proves that the drawing is the same without them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace epura::pipeline {

/// Enabled shortcuts. Tests and measurements disable them: every drawing stays the same to the byte.
struct Shortcuts {
  bool clip = true;           ///< by planes that have everything inside (view/projected_scene.hpp)
  bool intersections = true;  ///< of separate convex bodies (edges/crossing_candidates.hpp)
  bool visibility = true;     ///< of a surface that the page shows as one sheet (visibility/height_field.hpp)
  bool hidden = true;         ///< lines that are not drawn are not made (drawing/make_drawing.hpp)
  bool text = true;           ///< without texts no font is opened

  bool operator==(const Shortcuts&) const = default;
};

/// By the names of their stages in the plan.
const std::vector<std::pair<std::string, bool Shortcuts::*>>& shortcut_names();

/// "all", "none", or names with commas. Throws Error{input}.
Shortcuts parse_shortcuts(const std::string& text);

}  // namespace epura::pipeline
