// SPDX-License-Identifier: Apache-2.0
// One view through all stages: models in, drawing out.
#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "drawing/arcs.hpp"
#include "drawing/breaks.hpp"
#include "drawing/drawing.hpp"
#include "edges/find_edges.hpp"
#include "features/centred_features.hpp"
#include "report/report.hpp"
#include "scene/description.hpp"
#include "sheet/view_lines.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "views/broken_outs.hpp"
#include "views/budget.hpp"
#include "views/known_intersections.hpp"
#include "views/revolved.hpp"
#include "views/sections.hpp"
#include "views/shortcuts.hpp"
#include "visibility/visibility.hpp"
#include "world/exploded_world.hpp"
#include "world/facet_heights.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Options of a view except its projection.
struct ViewOptions {
  std::string name;
  view::ViewLimits limits;
  edges::EdgeOptions edges;
  bool wireframe = false;                       ///< nothing is hidden
  bool exploded = false;                        ///< bodies are not where dimensions find them
  bool shows_inside = true;                     ///< by hidden lines, a section or broken-out ones
  std::optional<cut::CuttingSurface> turned{};  ///< of an aligned section, whose parts are elsewhere, too
  std::optional<double> max_error;              ///< mm; chords are drawn as arcs only if they rise less
  sheet::BodyStyles styles;
  std::optional<int> verify;   ///< number of random points
  std::optional<double> arcs;  ///< tolerance in mm for recognising circles and ellipses
  bool centre_lines = false;
  std::optional<scene::DetailDescription> detail{};  ///< shown by the view
  std::vector<RevolvedSection> revolved{};
  drawing::Breaks breaks{};  ///< left out, in units and from the origin of view::drawn_box
  double join_within = 0.1;  ///< mm on paper; lines this close along each other are merged, 0: all are drawn
  double least_crease = 0;   ///< mm on paper; shorter creases that meet no other line are left out
  double min_thread = 1;     ///< mm on paper between the lines of crests and roots of threads
  Shortcuts leave_out{};

  /// Whether the hidden lines of some model are drawn.
  [[nodiscard]] bool keep_hidden() const;
};

/// Intermediate results of a drawing.
struct ViewWork {
  view::ProjectedScene view;
  edges::FeatureEdges drawn;
  visibility::HiddenSpans hidden;
  view::PaperMap paper;
};

struct ViewResult {
  ViewWork work;  ///< large; needed only for questions about the drawing
  drawing::ViewDrawing drawing;
  std::vector<report::PlanStep> plan;  ///< stages that were run, and omitted
  report::Partial partial;             ///< omitted for lack of time
  std::optional<report::Verification> verification;
  std::optional<cut::CuttingSurface> section;  ///< shown by the view
  drawing::CurveReport curves{};
  features::CentredFeatures features{};      ///< for centre lines, if requested
  std::optional<report::ViewError> error{};  ///< if its input has heights of facets
  double unsymmetric = 0;                    ///< mm of lines that a half view leaves out and does not show mirrored
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

/// Deadlines of a view.
struct ViewTime {
  Progress run;    ///< for everything
  Progress lines;  ///< for the lines of this view
};

/// A view to draw, and its position on the sheet.
struct ViewInput {
  const world::World& world;  ///< the cut one if the view shows a section
  const CutSection* section;  ///< null if it shows the whole
  const ViewOptions& options;
  PlaceOnPage place;
  std::span<const world::Trace> traces{};  ///< of moved bodies
  std::span<const BrokenOutSection> broken_out{};
  std::optional<KnownIntersections>* known = nullptr;  ///< of the world; null if no other view shows it
  const world::FacetHeights* heights = nullptr;        ///< of the uncut world; null if the view is not judged
};

/// Throws OutOfTime if time is over before there is a line to show; otherwise omissions are noted in the result.
ViewResult draw_view(const ViewInput& input, view::ProjectedScene view, const ViewTime& time, Stopwatch& watch);

}  // namespace epura::pipeline
