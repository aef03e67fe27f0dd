// SPDX-License-Identifier: Apache-2.0
// Revolved sections of the views of a scene.
#pragma once

#include <vector>

#include "cut/cut_world.hpp"
#include "scene/description.hpp"

namespace epura::cut {

/// Writes the name of its view into each revolved section. Views have names, and details their parents. Throws
/// Error{input} for views that do not exist, or show a detail.
void complete_revolved(scene::SceneDescription& scene);

/// The area around a point of a cutting plane in which the plane cuts through one body: an outline, and those of its
/// holes. The points of the cut world are in the plane.
struct FaceAtPoint {
  int model, body;
  std::vector<std::vector<Vec3>> rings;
};

/// Cuts the world by a plane through the point of a revolved section, of which only the area around the point remains.
/// Throws Error{input} if the plane cuts nothing, or there is no material at the point.
FaceAtPoint cut_face_at_point(const world::World& world, const scene::RevolvedDescription& section);

}  // namespace epura::cut
