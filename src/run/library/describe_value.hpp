// SPDX-License-Identifier: Apache-2.0
// Scenes in the words of scene files, with models in memory.
#pragma once

#include <epura/scene_value.hpp>
#include <vector>

#include "scene/description.hpp"

namespace epura {

/// Throws Error{input} at the place of a value, as for a scene file.
scene::SceneDescription describe_scene(const SceneValue& value, const std::vector<ModelSource>& sources);

}  // namespace epura
