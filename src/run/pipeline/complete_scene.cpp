// SPDX-License-Identifier: Apache-2.0
#include "pipeline/complete_scene.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "composition/annotations.hpp"
#include "cut/revolved.hpp"
#include "importer/read_model.hpp"
#include "scene/arrow_views.hpp"
#include "scene/details.hpp"
#include "scene/scene_file.hpp"
#include "scene/view_names.hpp"
#include "scene/view_sections.hpp"
#include "sheet/form.hpp"
#include "sheet/paper.hpp"
#include "views/choose.hpp"
#include "views/view_plan.hpp"
#include "world/exploded_world.hpp"

namespace epura::pipeline {

namespace {

// Separates the parameters of "part.step:deflection=0.01".
void take_parameters(scene::ModelDescription& model) {
  if (!model.file.given()) return;
  importer::ModelRequest request = importer::parse_model_request(*model.file);
  if (model.file.where == *model.file) model.file.where = request.path;
  model.file.value = std::move(request.path);
  model.import = std::move(request.parameters);
}

// "front:hidden=none": options of views, which short lists of projections may give to single ones.
template <class Value>
void take_option(scene::ViewDescription& view, const std::string& option, scene::Located<Value>& member) {
  if (!view.projection.given()) return;
  auto& assignments = view.projection.value->assignments;
  std::vector<std::pair<std::string, Value>> choices;
  for (const char* name : scene::Words<Value>::list) choices.emplace_back(name, static_cast<Value>(choices.size()));
  for (const auto& [key, word] : assignments)
    if (key == option) member = {choose<Value>(view.projection.where, word, choices), view.projection.where};
  std::erase_if(assignments, [&option](const auto& assignment) { return assignment.first == option; });
}

// "epura": plan and elevation on a sheet with that layout. Returns the sheets that are to have it, with the place of
// the word.
std::vector<std::pair<int, std::string>> expand_epuras(std::vector<scene::ViewDescription>& views) {
  std::vector<std::pair<int, std::string>> sheets;
  std::vector<scene::ViewDescription> expanded;
  for (const scene::ViewDescription& view : views) {
    if (!view.projection.given() || view.projection->name != "epura") {
      expanded.push_back(view);
      continue;
    }
    sheets.emplace_back(view.sheet.value_or(1), view.projection.where);
    for (const char* name : {"front", "top"}) {
      expanded.push_back(view);
      expanded.back().projection.value->name = name;
      expanded.back().name = {};
    }
  }
  views = std::move(expanded);
  return sheets;
}

// "auto": three views, and those that are found to be lacking once the models are read.
void expand_automatic(std::vector<scene::ViewDescription>& views) {
  std::vector<scene::ViewDescription> expanded;
  for (const scene::ViewDescription& view : views) {
    if (!view.projection.given() || view.projection->name != "auto") {
      expanded.push_back(view);
      continue;
    }
    for (const char* name : {"front", "top", "left"}) {
      expanded.push_back(view);
      expanded.back().projection.value->name = name;
      expanded.back().name = {};
      expanded.back().is_automatic = true;
    }
  }
  views = std::move(expanded);
}

// A form is drawn for one size of paper, which is that of its sheet.
void take_size_of_form(scene::SheetDescription& sheet) {
  if (!sheet.form.given()) return;
  if (sheet.frame.given() && *sheet.frame != FrameKind::automatic && *sheet.frame != FrameKind::full)
    throw Error(ErrorKind::input, sheet.frame.where, "a sheet with a template has the frame of that",
                "omit the frame, or the template");
  const Vec2 size = read_at_place(sheet.form, sheet::read_form)->art.size;
  const scene::PaperChoice own = sheet::paper_of_size(size);
  if (sheet.size.given() && sheet::size_name(*sheet.size) != sheet::size_name(own))
    throw Error(
        ErrorKind::input, sheet.size.where,
        "the template " + *sheet.form + " is for " + sheet::size_name(own) + ", not " + sheet::size_name(*sheet.size),
        "omit the size, or use a template of that size");
  sheet.size = {own, sheet.form.where};
  sheet.orientation = {size.y > size.x ? Orientation::portrait : Orientation::landscape, sheet.form.where};
}

}  // namespace

const char* usual_projection(const scene::SceneDescription& scene) {
  const auto draws_requirements = [](const scene::ModelDescription& model) {
    return model.pmi.value_or(Pmi::none) != Pmi::none;
  };
  const bool is_measured = dimensions_features(scene) || !scene.requirements.empty() ||
                           std::any_of(scene.models.begin(), scene.models.end(), draws_requirements);
  return is_measured ? "auto" : "isometric";
}

void complete_scene(scene::SceneDescription& scene) {
  for (scene::ModelDescription& model : scene.models) take_parameters(model);
  const auto is_piped = [](const scene::ModelDescription& model) {
    return model.file.given() && *model.file == importer::standard_input;
  };
  if (std::count_if(scene.models.begin(), scene.models.end(), is_piped) > 1)
    throw Error(ErrorKind::input, importer::standard_input, "standard input is one model, and is given twice");
  if (scene.views.empty())
    scene.views.emplace_back().projection = {scene::ProjectionRequest{usual_projection(scene)}, "--projection"};
  const auto epuras = expand_epuras(scene.views);
  expand_automatic(scene.views);
  for (scene::ViewDescription& view : scene.views) {
    take_option(view, "hidden", view.hidden);
    take_option(view, "half", view.half);
  }
  scene::take_view_sections(scene);
  for (const scene::ViewDescription& view : scene.views)
    if (view.of.given() && !view.projection.given()) {
      scene::complete_directions(scene);
      break;
    }
  scene::expect_projections(scene);
  scene::name_views(scene.views);
  scene::complete_details(scene);
  scene::complete_broken_outs(scene);
  cut::complete_revolved(scene);
  scene::complete_letters(scene);
  world::expect_sound_moves(scene);
  int sheets = 1;
  for (const scene::ViewDescription& view : scene.views) sheets = std::max(sheets, view.sheet.value_or(1));
  if (scene.sheets.empty()) scene.sheets.resize(static_cast<std::size_t>(sheets));
  for (const auto& [sheet, where] : epuras)
    if (sheet <= static_cast<int>(scene.sheets.size()))
      scene.sheets[static_cast<std::size_t>(sheet) - 1].layout = {SheetLayout::monge, where};
  scene::expect_sound_names(scene);
  expect_views_of_annotations(scene);
}

void complete_sheets(scene::SceneDescription& scene) {
  for (scene::SheetDescription& sheet : scene.sheets) take_size_of_form(sheet);
  // Nobody has chosen paper for views that nobody has chosen.
  for (const scene::ViewDescription& view : scene.views)
    if (const int sheet = view.sheet.value_or(1) - 1;
        view.is_automatic && sheet < static_cast<int>(scene.sheets.size()))
      if (auto& size = scene.sheets[static_cast<std::size_t>(sheet)].size; !size.given())
        size = {scene::PaperChoice{scene::PaperChoice::Kind::automatic, 0, {0, 0}}, view.projection.where};
}

}  // namespace epura::pipeline
