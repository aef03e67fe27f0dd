// SPDX-License-Identifier: Apache-2.0
// Converts options, and the scene file that they may name, to the description of the drawing.
#pragma once

#include <string>
#include <vector>

#include "app/options.hpp"
#include "scene/description.hpp"

namespace epura {

/// Whether a file is a scene by its name.
bool is_scene_file(const std::string& path);

/// Options override the scene file. Every description has models, views and sheets. Throws Error{input} for a scene
/// file together with models, and for options that conflict with a scene file.
scene::SceneDescription describe(const DrawOptions& options);

/// Completes a scene, with sheets as the options have them.
void complete(scene::SceneDescription& scene, const DrawOptions& options);

/// Returns the files that are read for the drawing.
std::vector<std::string> inputs_of(const DrawOptions& options, const scene::SceneDescription& scene);

}  // namespace epura
