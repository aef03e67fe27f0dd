// SPDX-License-Identifier: Apache-2.0
#include "pipeline/complete_scene.hpp"

#include <algorithm>

#include "pipeline/annotations.hpp"
#include "scene/scene_file.hpp"
#include "scene/view_names.hpp"

namespace epura {

void complete_scene(SceneDescription& scene) {
  if (scene.views.empty()) scene.views.emplace_back().projection = {ProjectionRequest{"isometric"}, "--projection"};
  int sheets = 1;
  for (const ViewDescription& view : scene.views) sheets = std::max(sheets, view.sheet.value_or(1));
  if (scene.sheets.empty()) scene.sheets.resize(static_cast<std::size_t>(sheets));
  name_views(scene.views);
  expect_sound_names(scene);
  expect_views_of_dimensions(scene);
}

}  // namespace epura
