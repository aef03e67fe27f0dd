// SPDX-License-Identifier: Apache-2.0
// Scenes of plain values, in the words of scene files.
#pragma once

#include <epura/scene.hpp>

#include "scene/description.hpp"

namespace epura {

/// Error locations are members of the scene: "models[0].faces[3]". Throws Error{input} for what scene files cannot say,
/// too.
scene::SceneDescription describe_scene(const Scene& scene);

}  // namespace epura
