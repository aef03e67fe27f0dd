// SPDX-License-Identifier: Apache-2.0
#include "pipeline/complete_scene.hpp"

#include <algorithm>
#include <utility>

#include "importer/read_model.hpp"
#include "pipeline/annotations.hpp"
#include "scene/scene_file.hpp"
#include "scene/view_names.hpp"

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

}  // namespace

void complete_scene(scene::SceneDescription& scene) {
  for (scene::ModelDescription& model : scene.models) take_parameters(model);
  if (scene.views.empty())
    scene.views.emplace_back().projection = {scene::ProjectionRequest{"isometric"}, "--projection"};
  int sheets = 1;
  for (const scene::ViewDescription& view : scene.views) sheets = std::max(sheets, view.sheet.value_or(1));
  if (scene.sheets.empty()) scene.sheets.resize(static_cast<std::size_t>(sheets));
  scene::name_views(scene.views);
  scene::expect_sound_names(scene);
  expect_views_of_dimensions(scene);
}

}  // namespace epura::pipeline
