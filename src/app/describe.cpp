// SPDX-License-Identifier: Apache-2.0
#include "app/describe.hpp"

#include <algorithm>
#include <filesystem>

#include "app/annotations.hpp"
#include "app/choose.hpp"
#include "base/error.hpp"
#include "base/text.hpp"
#include "scene/cutting_plane.hpp"
#include "scene/scene_file.hpp"
#include "scene/view_names.hpp"

namespace epura {

namespace {

bool is_scene_file(const std::string& path) {
  return to_lower(std::filesystem::path(path).extension().string()) == ".toml";
}

void set(Given& value, const std::string& option, const std::string& text) {
  if (!text.empty()) value = {text, option};
}

// The n-th transform belongs to the n-th model; a single one to all.
std::vector<ModelDescription> models_of(const DrawOptions& options) {
  const std::size_t transforms = options.transforms.size();
  if (transforms > 1 && transforms != options.models.size())
    throw Error(Trouble::input, "--transform", "is given neither once nor once for each model");
  std::vector<ModelDescription> models(options.models.size());
  for (std::size_t i = 0; i < models.size(); ++i) {
    models[i].file = {options.models[i], options.models[i]};
    set(models[i].unit, "--unit", options.unit);
    set(models[i].up, "--up", options.up);
    if (transforms > 0) set(models[i].transform, "--transform", options.transforms[transforms == 1 ? 0 : i]);
  }
  return models;
}

std::vector<ViewDescription> views_of(const DrawOptions& options) {
  std::vector<ViewDescription> views;
  const auto add = [&views](const std::string& option, std::string_view projection) {
    if (projection.empty()) throw Error(Trouble::input, option, "names no projection", "'epura plugins' lists them");
    views.emplace_back().projection = {std::string(projection), option};
  };
  if (!options.views.empty())
    for (const std::string_view name : split(options.views, ',')) add("--views", name);
  for (const std::string& projection : options.projections) add("--projection", projection);
  return views;
}

SceneDescription described_by_file(const DrawOptions& options) {
  const std::string& file = options.models.front();
  if (options.models.size() > 1)
    throw Error(Trouble::input, file, "is a scene file and stands beside other models",
                "name the models in the scene file, or leave it out");
  if (!options.transforms.empty() || !options.unit.empty() || !options.up.empty())
    throw Error(Trouble::input, file, "--transform, --unit and --up are for models that the command line names",
                "say it in the [[model]] of the scene file");
  SceneDescription scene = read_scene_file(file);
  std::vector<ViewDescription> views = views_of(options);
  if (!views.empty() && !scene.views.empty())
    throw Error(Trouble::input, file, "has views of its own",
                "leave out --views and --projection, or the views of the scene file");
  if (!views.empty()) scene.views = std::move(views);
  return scene;
}

void cut_by_option(SceneDescription& scene, const std::string& text) {
  const std::string option = "--section";
  if (scene.views.size() > 1 || !scene.sections.empty())
    throw Error(Trouble::input, option, "is for a single view and a scene without sections of its own",
                "write a [[section]] into the scene file and name it in the [[view]] that shows it");
  scene.sections.push_back(parse_section(text, option));
  scene.views.front().section = scene.sections.front().name;
}

void overrule(ViewDescription& view, const DrawOptions& options) {
  set(view.hidden, "--hidden", options.hidden);
  set(view.edges, "--edges", options.edges);
  if (options.crease_angle) view.crease_angle = options.crease_angle;
  if (options.near) view.near = options.near;
  if (options.far) view.far = options.far;
}

void overrule(SheetDescription& sheet, const DrawOptions& options) {
  set(sheet.size, "--sheet", options.sheet);
  set(sheet.orientation, "--" + options.orientation, options.orientation);
  set(sheet.scale, "--scale", options.scale);
  set(sheet.angle, "--" + options.angle + "-angle", options.angle);
  set(sheet.frame, "--frame", options.frame);
  for (const auto& [name, text] : options.title_block) {
    std::erase_if(sheet.title_block, [&name = name](const auto& field) { return field.first == name; });
    sheet.title_block.emplace_back(name, Given{text, "--title-block"});
  }
}

void add_dimensions(SceneDescription& scene, const std::string& which) {
  const std::string option = "--dimensions";
  DimensionDescription& dimension = scene.dimensions.emplace_back();
  dimension.where = option;
  dimension.type = {choose<std::string>(option, which, {{"overall", "overall"}}), option};
}

}  // namespace

SceneDescription describe(const DrawOptions& options) {
  SceneDescription scene;
  if (std::any_of(options.models.begin(), options.models.end(), is_scene_file)) {
    scene = described_by_file(options);
  } else {
    scene.models = models_of(options);
    scene.views = views_of(options);
  }
  if (scene.views.empty()) scene.views.emplace_back().projection = {"isometric", "--projection"};
  int sheets = 1;
  for (ViewDescription& view : scene.views) {
    overrule(view, options);
    sheets = std::max(sheets, view.sheet);
  }
  if (!options.section.empty()) cut_by_option(scene, options.section);
  name_views(scene.views);
  if (scene.sheets.size() < std::size_t(sheets)) scene.sheets.resize(std::size_t(sheets));
  for (SheetDescription& sheet : scene.sheets) overrule(sheet, options);
  if (!options.dimensions.empty()) add_dimensions(scene, options.dimensions);
  expect_views_of_dimensions(scene);
  return scene;
}

std::vector<std::string> inputs_of(const DrawOptions& options, const SceneDescription& scene) {
  std::vector<std::string> files = options.models;
  for (const ModelDescription& model : scene.models) files.push_back(model.file.text);
  return files;
}

}  // namespace epura
