// SPDX-License-Identifier: Apache-2.0
// Fills in the defaults of a scene and resolves its names.
#pragma once

#include "scene/description.hpp"

namespace epura::pipeline {

/// Afterwards, files are paths, all views are named and there is at least one, and all sheets to which views refer
/// exist. Throws Error{input} for names that are unknown or ambiguous.
void complete_scene(scene::SceneDescription& scene);

/// Gives sheets with a template the size of that, once all their options are known. Throws Error{input} if they have
/// another size or frame.
void complete_sheets(scene::SceneDescription& scene);

}  // namespace epura::pipeline
