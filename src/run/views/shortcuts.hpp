// SPDX-License-Identifier: Apache-2.0
// Stages that are skipped if a test proves that the drawing is the same without them.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace epura::pipeline {

/// Enabled shortcuts. Tests and measurements disable them: every drawing remains the same, byte by byte.
struct Shortcuts {
  bool clip = true;           ///< clipping by planes with everything inside (view/projected_scene.hpp)
  bool intersections = true;  ///< intersections of separate convex bodies (edges/crossing_candidates.hpp)
  bool visibility = true;     ///< hiding by a surface that appears as one sheet (visibility/height_field.hpp)
  bool hidden = true;         ///< making lines that are not drawn (drawing/make_drawing.hpp)
  bool text = true;           ///< opening a font if there are no texts

  bool operator==(const Shortcuts&) const = default;
};

/// By the names of their stages in the plan.
const std::vector<std::pair<std::string, bool Shortcuts::*>>& shortcut_names();

/// Parses "all", "none", or names separated by commas. Throws Error{input}.
Shortcuts parse_shortcuts(const std::string& text);

}  // namespace epura::pipeline
