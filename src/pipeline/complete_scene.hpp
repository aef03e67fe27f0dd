// SPDX-License-Identifier: Apache-2.0
// What nobody said of a scene is filled in, and its names are looked up.
#pragma once

#include "scene/description.hpp"

namespace epura::pipeline {

/// Afterwards files are paths, and there are views, all of them named, and a sheet for each that a view stands on.
/// Throws Error{input} for names that lead nowhere, or to two things.
void complete_scene(scene::SceneDescription& scene);

}  // namespace epura::pipeline
