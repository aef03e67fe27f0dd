// SPDX-License-Identifier: Apache-2.0
// How far the lines of a drawn view may be from those of the part.
#pragma once

#include "base/progress.hpp"
#include "drawing/arcs.hpp"
#include "drawing/make_drawing.hpp"
#include "drawing/view_drawing.hpp"
#include "edges/find_edges.hpp"
#include "report/error_budget.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"
#include "world/facet_heights.hpp"

namespace epura::accuracy {

/// A drawn view, to be judged.
struct ViewToJudge {
  const world::World& world;           ///< the cut one if the view shows a section
  const world::FacetHeights& heights;  ///< of the uncut world
  bool is_whole;                       ///< nothing is cut or moved: triangles are those of `heights`
  const view::ProjectedScene& view;
  const edges::FeatureEdges& edges;
  const visibility::HiddenSpans& hidden;
  const view::PaperMap& paper;
  const drawing::ViewDrawing& drawing;
  const drawing::DrawingOptions& options;  ///< those of the drawing
};

/// Returns all terms except `writing`. `hides` is false for wireframes. Where time ends, what is measured on ink is the
/// bound that the drawing has.
report::ViewError error_of_view(const ViewToJudge& judged, const drawing::CurveReport& curves, bool hides,
                                const Progress& progress = {});

/// No span longer than this fraction of the drawing is shown wrongly (docs/numerics.md).
inline constexpr double guaranteed_part = 1e-6;

}  // namespace epura::accuracy
