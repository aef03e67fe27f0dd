// SPDX-License-Identifier: Apache-2.0
// Fills in the defaults of a scene and resolves its names.
#pragma once

#include "scene/description.hpp"

namespace epura::pipeline {

/// The projection of a scene without views: an isometric view has no true sizes.
const char* usual_projection(const scene::SceneDescription& scene);

/// Afterwards, files are paths, all views are named and there is at least one, and all sheets to which views refer
/// exist. Throws Error{input} for names that are unknown or ambiguous.
void complete_scene(scene::SceneDescription& scene);

/// Gives sheets with a template the size of that, once all their options are known, and others with automatic views the
/// size `auto` if they have none. Throws Error{input} if those with a template have another size or frame.
void complete_sheets(scene::SceneDescription& scene);

}  // namespace epura::pipeline
