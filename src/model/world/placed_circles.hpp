// SPDX-License-Identifier: Apache-2.0
// Finds the circles of the models of a world, in world coordinates.
#pragma once

#include <vector>

#include "mesh/circles.hpp"
#include "world/world.hpp"

namespace epura::world {

/// Returns circles and arcs of a model in world coordinates, except those that a non-uniform scale turns into ellipses.
std::vector<mesh::MeshCircle> find_circles(const World& world, int model, double crease_angle = 30);

/// Returns those with centre lines: whole circles, and arcs of half a turn or more.
std::vector<mesh::MeshCircle> find_round_rims(const World& world, int model, double crease_angle = 30);

}  // namespace epura::world
