// SPDX-License-Identifier: Apache-2.0
// All drawn edges, or all their spans, as tab-separated tables: a header, then one line each, in the order of edges.
// Both functions throw OutOfTime.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "explain/hiders.hpp"
#include "explain/subject.hpp"

namespace epura::explain {

/// Columns: edge, kind, angle (degrees; "-" unless exactly two triangles meet), faces, ends on the page (mm), length in
/// the world.
std::string edge_table(const ExplainInput& drawn_view, const Progress& progress = {});

/// Columns: edge, kind, ends on the page (mm), t along the edge in space, visible or hidden; for hidden spans the
/// number of faces that hide them, the nearest of those that hide the middle, and its distance in front.
std::string span_table(const ExplainInput& drawn_view, const TriangleBoxes& boxes, const Progress& progress = {});

}  // namespace epura::explain
