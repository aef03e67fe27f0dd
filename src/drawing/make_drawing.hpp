// SPDX-License-Identifier: Apache-2.0
// Spans -> ink on paper.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "drawing/near_ink.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

struct DrawingOptions {
  std::string name;    ///< of the view
  bool hidden = true;  ///< keep hidden lines
  /// Those that are not kept are not made. They never had any influence: visible lines come first in rank.
  bool leave_out = true;
  NearLines near{};
};

/// The place at page parameter `s` of an edge, in mm.
Vec2 position_on_paper(const view::ProjectedScene& view, const view::PaperMap& paper, const edges::FeatureEdge& edge,
                       double s);

/// A page parameter of an edge as the parameter along the edge in space that it was clipped from.
double parameter_in_space(const view::ProjectedScene& view, const edges::FeatureEdge& edge, double s);

/// Lines within `tolerance` of each other over at least `min` are one line; mm.
struct Coincidence {
  double tolerance, min;
};
Coincidence coincidence_on_paper(const view::ProjectedScene& view, const view::PaperMap& paper);

/// Throws OutOfTime.
ViewDrawing make_drawing(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                         const DrawingOptions& options, const Progress& progress = {});

}  // namespace epura::drawing
