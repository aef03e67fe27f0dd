// SPDX-License-Identifier: Apache-2.0
// Points of a scene that are given by the name of a feature, "hole 3" or "face 12".
#pragma once

#include <vector>

#include "composition/lint.hpp"
#include "composition/requirement_ledger.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"
#include "views/options.hpp"
#include "views/view_plan.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Puts the datums of automatic dimensions that are points in the coordinates of a file into the world. Throws
/// Error{input} for points that are not on the models.
void place_datums(scene::SceneDescription& scene, const world::World& world);

/// Puts points of the world in the places of features, which the scene numbers as surfaces/numbers.hpp does:
/// - a hole: where its axis leaves the material
/// - a face: its middle, that of a cylinder, cone, sphere or torus on its axis
/// - of radii, diameters and arcs: the circle of the narrowest bore or of the cylinder
/// - of leaders: a point of the rim or face, and the rim
/// Throws Error{input} that says what there is for features that do not exist or are none of one model.
void find_features(scene::SceneDescription& scene, const world::World& world);

/// Adds the requirements of the scene to those of the files of its models, and their rows. Throws Error{input} for
/// features that do not exist, and for faces that are not recognised.
void state_by_features(std::vector<FileRequirements>& required, const scene::SceneDescription& scene,
                       const world::World& world);

/// All that the models of a scene and the scene itself require. Throws as read_models and state_by_features do.
std::vector<FileRequirements> requirements_of_scene(const scene::SceneDescription& scene, const RunOptions& options,
                                                    const Messages& messages);

/// The faces that the scene accepts as they are. Throws Error{input} for features that do not exist.
std::vector<AcceptedFaces> accepted_faces(const scene::SceneDescription& scene, const world::World& world);

/// Gives the details that a sheet shows the centres that the scene has found for them.
void find_details(SheetOfViews& sheet, const scene::SceneDescription& scene);

/// Puts the threads of the scene on the holes and shafts of the world at their points.
void find_threads(world::World& world, const scene::SceneDescription& scene);

}  // namespace epura::pipeline
