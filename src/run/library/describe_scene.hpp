// SPDX-License-Identifier: Apache-2.0
// Scenes of other programs, as structs and as values with names, in the words of scene files.
#pragma once

#include <epura/scene.hpp>
#include <epura/scene_value.hpp>
#include <vector>

#include "scene/description.hpp"

namespace epura {

/// Error locations are members of the scene: "models[0].faces[3]". Throws Error{input} for what scene files cannot say,
/// too.
scene::SceneDescription describe_scene(const Scene& scene);

/// With models in memory. Throws Error{input} at the place of a value, as for a scene file.
scene::SceneDescription describe_scene(const SceneValue& value, const std::vector<ModelSource>& sources);

}  // namespace epura
