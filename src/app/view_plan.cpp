// SPDX-License-Identifier: Apache-2.0
#include "app/view_plan.hpp"

#include <map>

#include "app/choose.hpp"

namespace epura {

namespace {

EdgeWishes edge_wishes(const ViewDescription& view) {
  EdgeWishes wishes;
  if (view.crease_angle) wishes.crease_angle = *view.crease_angle;
  if (!view.edges.given()) return wishes;
  wishes = {
      .contour = false, .boundary = false, .crease = false, .intersection = false, .crease_angle = wishes.crease_angle};
  for (const std::string_view part : split(view.edges.text, ',')) {
    const auto wish = choose<bool EdgeWishes::*>(view.edges.where, std::string(part),
                                                 {{"contour", &EdgeWishes::contour},
                                                  {"crease", &EdgeWishes::crease},
                                                  {"boundary", &EdgeWishes::boundary},
                                                  {"intersection", &EdgeWishes::intersection},
                                                  {"tangent", &EdgeWishes::tangent},
                                                  {"smooth", &EdgeWishes::smooth}});
    wishes.*wish = true;
  }
  return wishes;
}

// What a model says of itself wins over what the view says.
std::vector<ModelLook> looks_of(const SceneDescription& scene, const ViewDescription& view) {
  std::vector<ModelLook> looks;
  for (const ModelDescription& model : scene.models) {
    ModelLook& look = looks.emplace_back();
    if (view.hidden.given()) look.hidden = parse_hidden_lines(view.hidden.text, view.hidden.where);
    if (model.hidden.given()) look.hidden = parse_hidden_lines(model.hidden.text, model.hidden.where);
    if (model.line.given()) look.line = parse_line_role(model.line.text, model.line.where);
  }
  return looks;
}

std::optional<double> arc_tolerance(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto tolerance = parse_number(text);
  if (!tolerance || !(*tolerance > 0 && *tolerance <= 1))
    throw Error(Trouble::input, "--arcs", "'" + text + "' is no tolerance",
                "more than 0 and at most 1 mm are possible");
  return tolerance;
}

ViewWish wish_of(const SceneDescription& scene, const ViewDescription& view, const DrawOptions& options) {
  ViewWish wish;
  wish.name = view.name.text;
  wish.limits = {view.near, view.far};
  wish.edges = edge_wishes(view);
  wish.contact = options.contact;
  wish.method = parse_method(options.visibility, "--visibility");
  wish.looks = looks_of(scene, view);
  wish.arcs = arc_tolerance(options.arcs);
  wish.centre_lines = options.centre_lines;
  wish.leave_out = parse_leave_out(options.plan);
  if (options.verify && wish.method.way == Way::none)
    throw Error(Trouble::input, "--verify", "has nothing to test in a wireframe", "leave out --visibility none");
  if (options.time_limit && (wish.method.way == Way::sampled || wish.method.way == Way::item_buffer))
    throw Error(Trouble::input, "--time-limit", "cannot stop " + name_of(wish.method.way) + " visibility",
                "leave out --visibility");
  if (options.max_error && wish.method != Method())
    throw Error(Trouble::input, "--max-error", "chooses the method itself", "leave out --visibility");
  if (options.max_error && (options.time_limit || options.verify))
    throw Error(Trouble::input, "--max-error", "may choose a method that knows no --time-limit and no --verify",
                "leave out one of them");
  wish.max_error = options.max_error;
  if (options.verify) wish.verify = options.verify_samples;
  return wish;
}

}  // namespace

std::vector<PlannedView> plan_views(const SceneDescription& scene, const DrawOptions& options) {
  const auto folders = plugin_folders(options.plugin_path);
  std::map<std::string, ProjectionEntry> found;  // views of one projection ask one process
  const auto find = [&](const std::string& name) {
    const auto known = found.find(name);
    return known != found.end() ? known->second : found.emplace(name, find_projection(name, folders)).first->second;
  };
  std::vector<PlannedView> plans;
  for (const ViewDescription& view : scene.views) {
    const ViewWish wish = wish_of(scene, view, options);
    const auto plan = [&](const std::string& text) -> PlannedView {
      const ProjectionRequest request = parse_request(text);
      return {request, find(request.name), wish};
    };
    plans.push_back(parse_given(view.projection, plan));
  }
  return plans;
}

std::vector<SheetOfViews> views_by_sheet(const SceneDescription& scene, const std::vector<PlannedView>& plans) {
  std::vector<SheetOfViews> sheets;
  for (int sheet = 0; sheet < static_cast<int>(scene.sheets.size()); ++sheet) {
    SheetOfViews& here = sheets.emplace_back();
    here.sheet = sheet;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
      if (scene.views[i].sheet != sheet + 1) continue;
      here.descriptions.push_back(scene.views[i]);
      here.plans.push_back(plans[i]);
    }
    if (here.plans.empty())
      throw Error(Trouble::input, scene.sheets[std::size_t(sheet)].where,
                  "sheet " + std::to_string(sheet + 1) + " shows no view",
                  "write 'sheet = " + std::to_string(sheet + 1) + "' into a [[view]], or take the sheet away");
  }
  return sheets;
}

View look_at(const World& world, const PlannedView& plan, const ViewDescription& description) {
  const auto look = [&](const std::string&) {
    return make_view(world, make_projection(plan.entry, plan.request, world.box), plan.wish.limits,
                     plan.wish.leave_out.clip ? Clipping::where_needed : Clipping::everywhere);
  };
  return parse_given(description.projection, look);
}

}  // namespace epura
