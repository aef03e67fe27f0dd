// SPDX-License-Identifier: Apache-2.0
// Meshes that stand for a smooth surface, and are too coarse for the size at which they are drawn.
#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "pipeline/draw_view.hpp"
#include "scene/description.hpp"

namespace epura::pipeline {

/// Returns a warning, with a remedy, for each model whose outlines are visibly angular in the view, or whose mesh is
/// drawn by edges of the kind `smooth` where its outlines seem to be wanted. Parts, whose faces are recognised, have
/// none, and neither have machines of many bodies.
std::vector<std::string> warnings_of_coarse_meshes(const ViewInput& input, const drawing::ViewDrawing& drawing,
                                                   const scene::SceneDescription& scene, const Progress& progress);

}  // namespace epura::pipeline
