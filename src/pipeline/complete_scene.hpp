// SPDX-License-Identifier: Apache-2.0
// Fills in the defaults of a scene and resolves its names.
#pragma once

#include "scene/description.hpp"

namespace epura::pipeline {

/// Afterwards files are paths, and there are views, all of them named, and every sheet that a view refers to. Throws
/// Error{input} for names that lead nowhere, or to two things.
void complete_scene(scene::SceneDescription& scene);

}  // namespace epura::pipeline
