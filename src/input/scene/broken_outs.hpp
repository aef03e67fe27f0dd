// SPDX-License-Identifier: Apache-2.0
// Checks the broken-out sections of a scene and finds their views.
#pragma once

#include "scene/description.hpp"

namespace epura::scene {

/// Writes the name of its view into each broken-out section. Views have names, and details their parents. Throws
/// Error{input} for sections without a closed line or with two, and for views that do not exist, show a detail, or show
/// another section.
void complete_broken_outs(SceneDescription& scene);

}  // namespace epura::scene
