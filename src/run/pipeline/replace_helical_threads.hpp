// SPDX-License-Identifier: Apache-2.0
// Draws screw threads that are modelled as helical faces as ISO 6410-1 asks.
#pragma once

#include "base/progress.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Puts cylinders with threads of ISO 261 in the place of helical threads, adds their descriptions to the scene where
/// it has none, and says so. Threads of other sizes, and those that end in other ways, stay as they are. Throws
/// OutOfTime.
world::World replace_helical_threads(world::World world, scene::SceneDescription& scene, const Messages& messages,
                                     const Progress& progress);

}  // namespace epura::pipeline
