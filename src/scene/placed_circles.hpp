// SPDX-License-Identifier: Apache-2.0
// The circles of the models of a world, in world coordinates.
#pragma once

#include <vector>

#include "base/progress.hpp"
#include "mesh/circles.hpp"
#include "scene/scene.hpp"

namespace epura::scene {

/// Circles and arcs of a model where it stands; what a transform with unequal scales made ellipses of is none.
std::vector<mesh::MeshCircle> find_circles(const World& world, int model, double crease_angle = 30);

struct PlacedCircle {
  int model;
  mesh::MeshCircle circle;  ///< in world coordinates; vertices are those of the model's file
};

/// Of all models what drawings give centre lines: whole circles, and arcs of half a turn or more. Throws
/// OutOfTime.
std::vector<PlacedCircle> find_placed_circles(const World& world, double crease_angle = 30,
                                              const Progress& progress = {});

}  // namespace epura::scene
