// SPDX-License-Identifier: Apache-2.0
// Converts spans to ink on paper.
#pragma once

#include <string>

#include "base/progress.hpp"
#include "drawing/drawing.hpp"
#include "drawing/near_lines.hpp"
#include "view/paper_map.hpp"
#include "visibility/visibility.hpp"

namespace epura::drawing {

struct DrawingOptions {
  std::string name;    ///< of the view
  bool hidden = true;  ///< keep hidden lines
  /// Hidden lines that are not kept are not created. This does not change the result: visible lines come first in rank.
  bool leave_out = true;
  NearLines near{};
  double least_crease = 0;  ///< mm; shorter creases that meet no other line are left out
};

/// Returns the place at page parameter `s` of an edge, in mm.
Vec2 position_on_paper(const view::ProjectedScene& view, const view::PaperMap& paper, const edges::FeatureEdge& edge,
                       double s);

/// Converts a page parameter of an edge to the parameter along the edge in space before clipping.
double parameter_in_space(const view::ProjectedScene& view, const edges::FeatureEdge& edge, double s);

/// Lines within `tolerance` of each other over at least `min` are one line; both in mm.
struct Coincidence {
  double tolerance, min;
};
Coincidence coincidence_on_paper(const view::ProjectedScene& view, const view::PaperMap& paper);

/// Throws OutOfTime.
ViewDrawing make_drawing(const visibility::ResolvedView& lines, const view::PaperMap& paper,
                         const DrawingOptions& options, const Progress& progress = {});

/// Returns how far merging moved the ink of a drawing that these made, mm: the distance of Hausdorff between what is
/// drawn and all lines, at most LineDistances::joined_within, which stands for it in drawings of very many pieces.
/// Throws OutOfTime.
double merged_by(const visibility::ResolvedView& lines, const view::PaperMap& paper, const DrawingOptions& options,
                 const ViewDrawing& drawing, const Progress& progress = {});

}  // namespace epura::drawing
