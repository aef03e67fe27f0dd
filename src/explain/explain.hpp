// SPDX-License-Identifier: Apache-2.0
// Explanation of one edge, in sentences.
#pragma once

#include <string>

#include "explain/hiders.hpp"
#include "explain/subject.hpp"

namespace epura::explain {

/// Lines of text: why the edge is drawn or not, its spans, what hides each, and whose ink lies on it. Angles in
/// degrees, places on the page in mm, t along the edge in space as in JSON, distances in the world's unit.
std::string explain(const ExplainInput& drawn_view, const TriangleBoxes& boxes, const Subject& subject);

}  // namespace epura::explain
