// SPDX-License-Identifier: Apache-2.0
#include "pipeline/view_plan.hpp"

#include <map>

#include "pipeline/choose.hpp"

namespace epura {

namespace {

EdgeOptions edge_wishes(const ViewDescription& view) {
  const EdgeKinds kinds = view.edges.value_or({});
  EdgeOptions wishes{.contour = kinds.contour,
                     .boundary = kinds.boundary,
                     .crease = kinds.crease,
                     .intersection = kinds.intersection,
                     .tangent = kinds.tangent,
                     .smooth = kinds.smooth};
  wishes.crease_angle = view.crease_angle.value_or(wishes.crease_angle);
  return wishes;
}

// What a model says of itself wins over what the view says.
std::vector<ModelStyle> looks_of(const SceneDescription& scene, const ViewDescription& view) {
  std::vector<ModelStyle> looks;
  for (const ModelDescription& model : scene.models) {
    const ModelStyle usual;
    looks.push_back({model.line.value_or(usual.line), model.hidden.value_or(view.hidden.value_or(usual.hidden))});
  }
  return looks;
}

ViewOptions wish_of(const SceneDescription& scene, const ViewDescription& view, const RunOptions& options) {
  ViewOptions wish;
  wish.name = *view.name;
  wish.limits = {view.near.value, view.far.value};
  wish.edges = edge_wishes(view);
  wish.contact = options.contact;
  wish.wireframe = options.visibility == Visibility::none;
  wish.looks = looks_of(scene, view);
  wish.arcs = options.arcs;
  wish.centre_lines = options.centre_lines;
  wish.leave_out = options.plan;
  if (options.verify && wish.wireframe)
    throw Error(ErrorKind::input, "--verify", "has nothing to test in a wireframe", "leave out --visibility none");
  if (options.max_error && wish.wireframe)
    throw Error(ErrorKind::input, "--max-error", "cannot be kept by a wireframe", "leave out --visibility none");
  wish.max_error = options.max_error;
  if (options.verify) wish.verify = options.verify_samples;
  return wish;
}

}  // namespace

std::vector<PlannedView> plan_views(const SceneDescription& scene, const RunOptions& options) {
  const auto folders = plugin_folders(options.plugin_path);
  std::map<std::string, ProjectionEntry> found;  // views of one projection ask one process
  const auto find = [&](const std::string& name) {
    const auto known = found.find(name);
    return known != found.end() ? known->second : found.emplace(name, find_projection(name, folders)).first->second;
  };
  std::vector<PlannedView> plans;
  for (const ViewDescription& view : scene.views) {
    const ViewOptions wish = wish_of(scene, view, options);
    const auto plan = [&](const ProjectionRequest& request) -> PlannedView {
      return {request, find(request.name), wish};
    };
    plans.push_back(at_place(view.projection, plan));
  }
  return plans;
}

std::vector<SheetOfViews> views_by_sheet(const SceneDescription& scene, const std::vector<PlannedView>& plans) {
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
                  "write 'sheet = " + std::to_string(sheet + 1) + "' into a [[view]], or take the sheet away");
  }
  return sheets;
}

ProjectedScene project_scene(const World& world, const PlannedView& plan, const ViewDescription& description) {
  const auto look = [&](const ProjectionRequest&) {
    return make_view(world, make_projection(plan.entry, plan.request, world.box), plan.wish.limits,
                     plan.wish.leave_out.clip ? Clipping::where_needed : Clipping::everywhere);
  };
  return at_place(description.projection, look);
}

}  // namespace epura
