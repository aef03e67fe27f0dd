// SPDX-License-Identifier: Apache-2.0
// The options of all commands except `draw`.
#pragma once

#include "app/options.hpp"
#include "scene/option.hpp"

namespace epura {

scene::Options<InfoOptions> info_options();
scene::Options<RequirementsOptions> requirements_options();
scene::Options<PluginsOptions> plugins_options();
scene::Options<PictureOptions> picture_options();
scene::Options<CheckPluginOptions> check_plugin_options();
scene::Options<ImportersOptions> importers_options();
scene::Options<CheckImporterOptions> check_importer_options();
scene::Options<NewProjectionOptions> new_projection_options();
scene::Options<NewSceneOptions> new_scene_options();

}  // namespace epura
