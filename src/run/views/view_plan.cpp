// SPDX-License-Identifier: Apache-2.0
#include "views/view_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "scene/body_styles.hpp"
#include "scene/details.hpp"
#include "sheet/arrangement.hpp"
#include "sheet/lettering.hpp"
#include "views/choose.hpp"
#include "views/view_error.hpp"

namespace epura::pipeline {

namespace {

edges::EdgeOptions edge_options(const scene::ViewDescription& view) {
  const EdgeKinds kinds = view.edges.value_or({});
  edges::EdgeOptions edges{.contour = kinds.contour,
                           .boundary = kinds.boundary,
                           .crease = kinds.crease,
                           .intersection = kinds.intersection,
                           .wire = kinds.wire,
                           .tangent = kinds.tangent,
                           .smooth = kinds.smooth};
  if (view.crease_angle.given()) edges.crease_angle = edges.part_angle = *view.crease_angle;
  edges.weak_angle = view.weak_crease_angle.value_or(edges.weak_angle);
  return edges;
}

// The style of a body whose model and view say `usual`.
sheet::BodyStyle style_of(const world::World& world, int model, int body, const sheet::BodyStyle& usual,
                          LayersBy layers) {
  const world::Placed& placed = world.models[static_cast<std::size_t>(model)];
  sheet::BodyStyle style = usual;
  if (const auto styles = world.styles_of(model); !styles.empty()) {
    const scene::StyleDescription& wanted = styles[static_cast<std::size_t>(body)];
    style.line = wanted.line.value_or(style.line);
    style.hidden = wanted.hidden.value_or(style.hidden);
    if (wanted.colour.given()) {
      const scene::ColourChoice& choice = *wanted.colour;
      style.colour = choice.of_file ? scene::colour_of_body(*placed.mesh, body).value_or(Colour{}) : choice.colour;
    }
    if (wanted.hatch.given() && style.hatch.pattern != HatchPattern::none) style.hatch.pattern = *wanted.hatch;
    style.hatch.angle = wanted.hatch_angle.value;
    style.hatch.pitch = wanted.hatch_pitch.value;
  }
  const std::string& name = scene::name_of_body(*placed.mesh, body);
  if (layers == LayersBy::body && !name.empty()) style.layer = name;
  return style;
}

ViewOptions view_options(const scene::ViewDescription& view, const RunOptions& run) {
  ViewOptions options;
  options.name = *view.name;
  options.limits = {view.near.value, view.far.value, run.contact};
  options.edges = edge_options(view);
  options.wireframe = run.visibility == Visibility::none;
  options.join_within = view.join_within.value_or(options.join_within);
  options.least_crease = view.least_crease.value_or(options.least_crease);
  options.arcs = run.arcs;
  options.centre_lines = view.centre_lines.value_or(run.centre_lines);
  options.leave_out = run.plan;
  if (run.verify && options.wireframe)
    throw Error(ErrorKind::input, "--verify", "cannot test a wireframe", "omit --visibility none");
  if (run.max_error && options.wireframe)
    throw Error(ErrorKind::input, "--max-error", "cannot be guaranteed for a wireframe", "omit --visibility none");
  options.max_error = run.max_error;
  if (run.max_error && !view.join_within.given())
    options.join_within = join_within(*run.max_error, options.join_within);
  if (run.verify) options.verify = run.verify_samples;
  return options;
}

}  // namespace

bool dimensions_features(const scene::SceneDescription& scene) {
  return std::any_of(scene.dimensions.begin(), scene.dimensions.end(),
                     [](const auto& dimension) { return dimension.type.value == DimensionType::automatic; });
}

bool has_centre_lines(const scene::SceneDescription& scene, const RunOptions& options) {
  const auto has = [&](const scene::ViewDescription& view) { return view.centre_lines.value_or(options.centre_lines); };
  return dimensions_features(scene) || std::any_of(scene.views.begin(), scene.views.end(), has);
}

std::vector<PlannedView> plan_views(const scene::SceneDescription& scene, const RunOptions& options) {
  const auto folders = projection::plugin_folders(options.plugin_path);
  std::map<std::string, projection::ProjectionEntry> found;  // views with the same projection share a process
  const auto find = [&](const std::string& name) {
    const auto known = found.find(name);
    if (known != found.end()) return known->second;
    return found.emplace(name, projection::find_projection(name, folders, options.projections)).first->second;
  };
  std::vector<PlannedView> plans;
  for (const scene::ViewDescription& view : scene.views) {
    ViewOptions of_view = view_options(view, options);
    if (view.detail.given()) of_view.detail = *scene::find_detail(scene, *view.detail);
    // Positions of holes and pitch circles are dimensioned at their centre lines.
    of_view.centre_lines = of_view.centre_lines || dimensions_features(scene);
    const auto plan = [&](const scene::ProjectionRequest& request) -> PlannedView {
      return {request, find(request.name), of_view};
    };
    plans.push_back(at_place(view.projection, plan));
  }
  return plans;
}

// Options of a model override those of the view, and styles of its bodies override both.
sheet::BodyStyles styles_of(const scene::SceneDescription& scene, const scene::ViewDescription& view,
                            const world::World& world, const projection::Projection& projection) {
  const bool is_pictorial = sheet::view_place(projection) == sheet::ViewPlace::pictorial;
  const LayersBy layers = view.layers.value_or(LayersBy::role);
  sheet::BodyStyles styles;
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const scene::ModelDescription& model =
        scene.models[static_cast<std::size_t>(world.number_in_scene(static_cast<int>(i)))];
    const world::Placed& placed = world.models[i];
    sheet::BodyStyle usual;
    usual.line = model.line.value_or(usual.line);
    if (is_pictorial || view.section.given()) usual.hidden = HiddenLines::none;
    usual.hidden = model.hidden.value_or(view.hidden.value_or(usual.hidden));
    usual.hatch.pattern = view.hatch.value;
    if (layers == LayersBy::body) usual.layer = scene::name_of(model);
    // Without names, the bodies of a model have one style.
    const mesh::MeshReport& report = placed.mesh->report;
    const int bodies = report.body_names.empty() ? std::min(report.bodies, 1) : report.bodies;
    std::vector<sheet::BodyStyle>& of_model = styles.of_model.emplace_back();
    for (int body = 0; body < bodies; ++body)
      of_model.push_back(style_of(world, static_cast<int>(i), body, usual, layers));
    if (of_model.empty()) of_model.push_back(usual);
  }
  return styles;
}

bool shows_parts(const SheetOfViews& views) {
  return std::any_of(views.plans.begin(), views.plans.end(),
                     [](const PlannedView& plan) { return plan.entry.family == "orthographic"; });
}

std::vector<SheetOfViews> views_by_sheet(const scene::SceneDescription& scene, const std::vector<PlannedView>& plans) {
  std::vector<SheetOfViews> sheets;
  for (int sheet = 0; sheet < static_cast<int>(scene.sheets.size()); ++sheet) {
    SheetOfViews& here = sheets.emplace_back();
    here.sheet = sheet;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
      if (scene.views[i].sheet.value_or(1) != sheet + 1) continue;
      here.descriptions.push_back(scene.views[i]);
      here.plans.push_back(plans[i]);
    }
    if (here.plans.empty())
      throw Error(ErrorKind::input, scene.sheets[std::size_t(sheet)].where,
                  "sheet " + std::to_string(sheet + 1) + " shows no view",
                  "write 'sheet = " + std::to_string(sheet + 1) + "' in a [[view]], or remove the sheet");
  }
  return sheets;
}

view::ProjectedScene project_scene(const world::World& world, const PlannedView& plan,
                                   const scene::ViewDescription& description) {
  const auto look = [&](const scene::ProjectionRequest&) {
    return view::project_scene(world, projection::make_projection(plan.entry, plan.request, world.box),
                               plan.options.limits,
                               plan.options.leave_out.clip ? view::Clipping::where_needed : view::Clipping::everywhere);
  };
  return at_place(description.projection, look);
}

report::PlanStep plugins_step(const std::vector<SheetOfViews>& sheets) {
  std::set<std::filesystem::path> opened;
  long long views = 0;
  for (const SheetOfViews& sheet : sheets)
    for (const PlannedView& view : sheet.plans) {
      opened.insert(view.entry.plugin);
      ++views;
    }
  return {"plugins", false, "only those that views name are opened", views, static_cast<long long>(opened.size())};
}

report::PlanStep text_step(const sheet::Sheet& sheet, bool leave_out) {
  long long texts = 0;
  for (const sheet::Layer& layer : sheet.layers) texts += static_cast<long long>(layer.texts.size());
  if (texts == 0 && !leave_out) sheet::Lettering();
  return {"text",
          texts > 0 || !leave_out,
          texts > 0    ? "there are texts"
          : !leave_out ? "requested by --plan"
                       : "there are no texts: no font is opened",
          texts,
          texts,
          {},
          texts == 0 && leave_out ? 1 : 0};
}

}  // namespace epura::pipeline
