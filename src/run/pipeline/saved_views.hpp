// SPDX-License-Identifier: Apache-2.0
// Views that model files have stored, in place of the requests for them.
#pragma once

#include "scene/description.hpp"
#include "views/options.hpp"

namespace epura::pipeline {

/// Reads the models if views ask for `saved`, which is all that they have stored, or `saved:NAME`. Each becomes a view
/// from its direction, named and labelled as in the file, and if the file clips it, a section by the first plane.
/// Throws Error{input} if there is none of this name. Before complete_scene.
void expand_saved_views(scene::SceneDescription& scene, const RunOptions& options);

}  // namespace epura::pipeline
