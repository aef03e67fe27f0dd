// SPDX-License-Identifier: Apache-2.0
// The error budget of a view, and the settings that keep it below --max-error.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "drawing/arcs.hpp"
#include "drawing/view_drawing.hpp"
#include "edges/find_edges.hpp"
#include "report/error_budget.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "views/messages.hpp"
#include "views/options.hpp"
#include "visibility/visibility.hpp"
#include "world/facet_heights.hpp"

namespace epura::pipeline {

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
  double merged;  ///< drawing::merged_by
};

/// Returns all terms except `writing`. `hides` is false for wireframes.
report::ViewError error_of_view(const ViewToJudge& judged, const drawing::CurveReport& curves, bool hides);

/// No span longer than this fraction of the drawing is shown wrongly (docs/numerics.md).
inline constexpr double guaranteed_part = 1e-6;

// What --max-error chooses.

/// Returns the part of --max-error for facets, mm. It includes that of arcs if none are drawn.
double part_for_facets(double max_error, bool has_arcs);
/// Returns the distance within which lines are merged, mm.
double join_within(double max_error, double usual);
/// Refuses a --max-error that is below what is certain of any drawing. `facets`: its part for facets, as a fraction of
/// the largest drawing; 0: unknown. Throws Error{input}.
void expect_certain(double max_error, double facets, bool has_arcs);

/// Refuses a view whose error exceeds --max-error. `declares_surfaces`: all files have the surfaces of their parts, of
/// which finer facets have been asked for already. Throws Error{input}.
void expect_within(double max_error, const report::ViewError& error, bool declares_surfaces);

/// "front: lines are within 0.021 mm of the part; most of it, 0.02 mm, by facets instead of their surface (measured)"
std::string sentence_of(const report::ViewError& error);

}  // namespace epura::pipeline
