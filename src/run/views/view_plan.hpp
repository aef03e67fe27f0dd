// SPDX-License-Identifier: Apache-2.0
// Descriptions of views -> parsed view options.
#pragma once

#include <vector>

#include "projection/catalogue.hpp"
#include "report/report.hpp"
#include "scene/description.hpp"
#include "sheet/sheet.hpp"
#include "views/draw_view.hpp"
#include "views/options.hpp"
#include "world/items.hpp"

namespace epura::pipeline {

/// A view before the models are read; all errors in its words have been found.
struct PlannedView {
  scene::ProjectionRequest request;
  projection::ProjectionEntry entry;
  ViewOptions options;
};

/// Whether features are to be dimensioned.
bool dimensions_features(const scene::SceneDescription& scene);

/// Throws Error{input}, or Error{plugin} for projections that do not exist.
std::vector<PlannedView> plan_views(const scene::SceneDescription& scene, const RunOptions& options);

/// Whether any view has centre lines: faces are recognised for them.
bool has_centre_lines(const scene::SceneDescription& scene, const RunOptions& options);

/// The views that are the plan and the elevation of an épura, by their numbers on the sheet.
struct EpuraViews {
  std::size_t elevation, plan;
};

/// How a sheet is to be laid out as far as the scene leaves that open.
struct LayoutRequest {
  int min_size = 0;                    ///< from which "auto" chooses, of its sizes in ascending order
  std::optional<double> kept_scale{};  ///< instead of the largest one
  double room_share = 1;               ///< of what is estimated as room for dimensions
};

/// A sheet, and the scene's views on it.
struct SheetOfViews {
  int sheet;
  std::vector<scene::ViewDescription> descriptions;
  std::vector<PlannedView> plans;
  bool states_error = false;  ///< above the title block
  LayoutRequest layout{};
  std::vector<world::Item> items{};   ///< of its parts list; empty: it has none
  std::optional<EpuraViews> epura{};  ///< if they have that layout
};

/// Whether a sheet has more than pictures: these show helical threads as they are.
bool shows_parts(const SheetOfViews& views);

/// In the order of the sheets; a sheet may have no views.
std::vector<SheetOfViews> views_by_sheet(const scene::SceneDescription& scene, const std::vector<PlannedView>& plans);

/// The styles of all bodies in a view. Pictorial views (ISO 5456-3) and sections have no hidden lines unless
/// these are requested.
sheet::BodyStyles styles_of(const scene::SceneDescription& scene, const scene::ViewDescription& view,
                            const world::World& world, const projection::Projection& projection);

/// The projected world, not on paper yet. Throws Error{input} for parameter values that do not fit the world.
view::ProjectedScene project_scene(const world::World& world, const PlannedView& plan,
                                   const scene::ViewDescription& description);

/// Views in, opened plugins out.
report::PlanStep plugins_step(const std::vector<SheetOfViews>& sheets);
/// Texts in and out. Without texts, no font is opened unless `leave_out` is false.
report::PlanStep text_step(const sheet::Sheet& sheet, bool leave_out);

}  // namespace epura::pipeline
