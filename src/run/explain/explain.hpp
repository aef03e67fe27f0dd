// SPDX-License-Identifier: Apache-2.0
// Explains one edge in sentences.
#pragma once

#include <string>

#include "explain/hiders.hpp"
#include "explain/subject.hpp"

namespace epura::explain {

/// Returns lines of text: why the edge is drawn or not, its spans, what hides each, and which lines have their ink.
/// Angles are in degrees, positions on the page in mm, distances in units of the world; t runs along the edge in space
/// as in JSON.
std::string explain(const ExplainInput& drawn_view, const TriangleBoxes& boxes, const Subject& subject);

}  // namespace epura::explain
