// SPDX-License-Identifier: Apache-2.0
#include "app/describe.hpp"

#include <algorithm>
#include <filesystem>

#include "base/error.hpp"
#include "base/text.hpp"
#include "pipeline/complete_scene.hpp"
#include "pipeline/saved_views.hpp"
#include "pipeline/targets.hpp"
#include "scene/part_options.hpp"
#include "scene/scene_file.hpp"

namespace epura {

namespace {

// The n-th transform applies to the n-th model; a single one to all models.
std::vector<scene::ModelDescription> models_of(const DrawOptions& options) {
  const std::size_t transforms = options.transforms.size();
  if (transforms > 1 && transforms != options.models.size())
    throw Error(ErrorKind::input, "--transform", "must be given once, or once for each model");
  std::vector<scene::ModelDescription> models(options.models.size(), options.model);
  for (std::size_t i = 0; i < models.size(); ++i) {
    models[i].file = {options.models[i], options.models[i]};
    if (transforms > 0) models[i].transform = options.transforms[transforms == 1 ? 0 : i];
  }
  return models;
}

std::vector<scene::ViewDescription> views_of(const DrawOptions& options) {
  std::vector<scene::ViewDescription> views;
  for (const auto& projection : options.views) views.emplace_back().projection = projection;
  for (const auto& projection : options.projections) views.emplace_back().projection = projection;
  return views;
}

scene::SceneDescription described_by_file(const DrawOptions& options) {
  const std::string& file = options.models.front();
  if (options.models.size() > 1)
    throw Error(ErrorKind::input, file, "is a scene file and cannot be combined with other models",
                "name the models in the scene file, or omit it");
  const scene::ModelDescription& model = options.model;
  if (!options.transforms.empty() || model.unit.given() || model.up.given() || model.surfaces.given() ||
      model.density.given())
    throw Error(ErrorKind::input, file,
                "--transform, --unit, --up, --surfaces and --density apply only to models on the command line",
                "set them in [[model]] of the scene file");
  scene::SceneDescription scene = scene::read_scene_file(
      file, options.run.allow_outside ? scene::FilesOutside::allowed : scene::FilesOutside::refused);
  std::vector<scene::ViewDescription> views = views_of(options);
  if (!views.empty() && !scene.views.empty())
    throw Error(ErrorKind::input, file, "already defines views",
                "omit --views and --projection, or the views of the scene file");
  if (!views.empty()) scene.views = std::move(views);
  return scene;
}

void cut_by_option(scene::SceneDescription& scene, const scene::Located<scene::SectionDescription>& section) {
  if (scene.views.size() > 1 || !scene.sections.empty())
    throw Error(ErrorKind::input, section.where, "needs a single view and a scene file without sections",
                "add a [[section]] to the scene file and name it in the [[view]] that shows it");
  scene.sections.push_back(*section);
  scene.views.front().section = section->name;
}

// X, Y, Z, W, V ...: a name for each detail.
std::string name_of_detail(std::size_t number) {
  const std::string names = "XYZWVUTSR";
  return number < names.size() ? names.substr(number, 1) : "X" + std::to_string(number);
}

void add_details(scene::SceneDescription& scene, const std::vector<scene::Located<scene::DetailRequest>>& details) {
  if (details.empty()) return;
  if (!scene.details.empty())
    throw Error(ErrorKind::input, details.front().where, "needs a scene file without details",
                "add a [[detail]] to the scene file, and a [[view]] that shows it");
  for (const scene::Located<scene::DetailRequest>& request : details) {
    const scene::LocatedText name{name_of_detail(scene.details.size()), request.where};
    scene.details.push_back({name, {}, {request->centre, request.where}, {request->radius, request.where}});
    scene::ViewDescription& view = scene.views.emplace_back();
    view.detail = name;
    view.scale = {request->scale, request.where};
  }
}

void add_dimensions(scene::SceneDescription& scene, const DrawOptions& options) {
  const scene::Located<AutomaticDimensions>& option = options.dimensions;
  const bool overall = *option == AutomaticDimensions::overall;
  scene::DimensionDescription& dimension = scene.dimensions.emplace_back();
  dimension.where = option.where;
  dimension.type = {overall ? DimensionType::overall : DimensionType::automatic, option.where};
  if (*option == AutomaticDimensions::hole_table) dimension.holes = {HoleDimensions::table, option.where};
  dimension.arrangement = options.arrangement;
  if (!options.datum.given()) return;
  dimension.anchors.push_back(*options.datum);
  dimension.of_file = options.datum.where;
}

}  // namespace

bool is_scene_file(const std::string& path) {
  return to_lower(std::filesystem::path(path).extension().string()) == ".toml";
}

scene::SceneDescription describe(const DrawOptions& options) {
  scene::SceneDescription scene;
  if (std::any_of(options.models.begin(), options.models.end(), is_scene_file)) {
    scene = described_by_file(options);
  } else {
    scene.models = models_of(options);
    scene.views = views_of(options);
  }
  for (const std::string& where : {options.arrangement.where, options.datum.where})
    if (!where.empty() && options.dimensions.value_or(AutomaticDimensions::overall) == AutomaticDimensions::overall)
      throw Error(ErrorKind::input, where, "needs automatic dimensions", "add --dimensions auto");
  if (options.dimensions.given()) add_dimensions(scene, options);
  for (scene::ViewDescription& view : scene.views) scene::overrule(view, options.view, scene::view_options());
  const bool is_single = options.section.given() || !options.details.empty();
  if (scene.views.empty())
    (scene.views.emplace_back() = options.view).projection = {
        scene::ProjectionRequest{is_single ? "isometric" : pipeline::usual_projection(scene)}, "--projection"};
  if (options.section.given()) cut_by_option(scene, options.section);
  add_details(scene, options.details);
  if (options.explode.given()) scene.explosions.push_back({.where = options.explode.where, .factor = options.explode});
  scene.dimensions.insert(scene.dimensions.end(), options.tolerances.begin(), options.tolerances.end());
  if (options.parts_list && !scene.parts_list) scene.parts_list = scene::PartsListDescription{"--parts-list"};
  pipeline::expand_saved_views(scene, options.run);
  complete(scene, options);
  return scene;
}

void complete(scene::SceneDescription& scene, const DrawOptions& options) {
  pipeline::complete_scene(scene);
  for (scene::SheetDescription& sheet : scene.sheets) {
    scene::overrule(sheet, options.sheet, scene::sheet_options());
    scene::overrule(sheet.title_block, options.sheet.title_block, scene::title_block_options());
  }
  pipeline::complete_sheets(scene);
}

std::vector<std::string> inputs_of(const DrawOptions& options, const scene::SceneDescription& scene) {
  std::vector<std::string> files = options.models;
  if (options.revise.given()) files.push_back(*options.revise);
  for (std::string& model : pipeline::inputs_of(scene)) files.push_back(std::move(model));
  return files;
}

}  // namespace epura
