// SPDX-License-Identifier: Apache-2.0
// One view through all stages: models in, drawing out.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "drawing/arcs.hpp"
#include "drawing/drawing.hpp"
#include "drawing/make_drawing.hpp"
#include "edges/find_edges.hpp"
#include "pipeline/budget.hpp"
#include "pipeline/sections.hpp"
#include "pipeline/shortcuts.hpp"
#include "report/report.hpp"
#include "scene/centred_features.hpp"
#include "scene/scene.hpp"
#include "sheet/view_lines.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"

namespace epura::pipeline {

/// Options of a view apart from its projection.
struct ViewOptions {
  std::string name;
  view::ViewLimits limits;
  edges::EdgeOptions edges;
  bool wireframe = false;           ///< nothing is hidden
  std::optional<double> max_error;  ///< mm; no longer span may be shown wrongly
  sheet::BodyStyles styles;
  std::optional<int> verify;   ///< number of random points
  std::optional<double> arcs;  ///< tolerance in mm for recognising circles and ellipses
  bool centre_lines = false;
  double join_within = 0.1;  ///< mm of paper; lines so near along each other are one, 0: all are drawn
  Shortcuts leave_out{};

  /// Whether the hidden lines of some model are drawn.
  [[nodiscard]] bool keep_hidden() const;
};

/// What was computed on the way to a drawing.
struct ViewWork {
  view::ProjectedScene view;
  edges::FeatureEdges drawn;
  visibility::HiddenSpans hidden;
  view::PaperMap paper;
};

struct ViewResult {
  ViewWork work;  ///< large; of use only for questions about the drawing
  drawing::ViewDrawing drawing;
  std::vector<report::PlanStep> plan;  ///< what was done, and left out
  report::Partial partial;             ///< what is left out because time was over
  std::optional<report::Verification> verification;
  std::optional<scene::CuttingPlane> section;  ///< that the view shows
  drawing::CurveReport curves{};
  scene::CentredFeatures features{};  ///< for centre lines, if requested
  std::optional<double> max_error{};  ///< mm; where one was allowed, no longer span is shown wrongly
};

/// Seconds since the last call of `lap`, under a name.
class Stopwatch {
 public:
  void lap(const std::string& stage);
  [[nodiscard]] const std::vector<std::pair<std::string, double>>& laps() const { return laps_; }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<std::pair<std::string, double>> laps_;
};

/// Position of a drawing on its sheet: page = scale * plane + shift, mm.
struct PlaceOnPage {
  double scale;
  Vec2 shift;
};

/// What there is of a view's time.
struct ViewTime {
  Progress run;    ///< all is to be done by then
  Progress lines;  ///< the lines of this view are to be there by then
};

/// A view to draw, and its position on the sheet.
struct ViewInput {
  const scene::World& world;  ///< the cut one where the view shows a section
  const CutSection* section;  ///< null where it shows the whole
  const ViewOptions& options;
  PlaceOnPage place;
};

/// Throws OutOfTime where time is over before there is a line to show; else what was left out is noted in the result.
ViewResult draw_view(const ViewInput& input, view::ProjectedScene view, const ViewTime& time, Stopwatch& watch);

}  // namespace epura::pipeline
