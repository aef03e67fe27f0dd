// SPDX-License-Identifier: Apache-2.0
// Recognises the faces of the parts in a scene.
#pragma once

#include "base/progress.hpp"
#include "report/report.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"
#include "views/options.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// The name of the stage.
inline constexpr const char* recognising_faces = "recognising faces";

/// Recognises faces that the file does not declare, if requested and useful, and adds a step to the plan of the report.
/// Models for which there is no time are drawn as meshes, and reported; it is not begun with less time than there has
/// been until now, for reading: it takes longer. The report also has the error of tessellation.
void recognise_parts(world::World& world, const scene::SceneDescription& scene, const RunOptions& options,
                     report::Report& report, Progress progress);

/// Turns a part that lies askew to the axes along which it is to be seen, and tells so: dimensions are along its own
/// axes, from datums that are turned with it. Only where the scene refers to no other place of the world, and all its
/// views are automatic.
void turn_to_own_axes(world::World& world, scene::SceneDescription& scene, const Messages& messages);

}  // namespace epura::pipeline
