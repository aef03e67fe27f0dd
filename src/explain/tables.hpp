// SPDX-License-Identifier: Apache-2.0
// All drawn edges, or all their spans, as tables: a header, then a line each, tab-separated, in order of the edges.
// Both throw OutOfTime.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "explain/hiders.hpp"
#include "explain/subject.hpp"

namespace epura::explain {

/// edge, kind, angle (degrees, "-" where not two triangles meet), faces, ends on the page (mm), length in the world.
std::string edge_table(const ExplainInput& drawn_view, const Progress& progress = {});

/// edge, kind, ends on the page (mm), t along the edge in space, visible or hidden, and of hidden spans how many faces
/// hide them, which of those over its middle is the nearest to it, and how far it lies in front.
std::string span_table(const ExplainInput& drawn_view, const TriangleBoxes& boxes, const Progress& progress = {});

}  // namespace epura::explain
