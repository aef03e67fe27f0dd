// The circles of all models of a world, in world coordinates.
#pragma once

#include <vector>

#include "mesh/circles.hpp"
#include "scene/scene.hpp"

namespace epura {

struct PlacedCircle {
  int model;
  MeshCircle circle;  ///< in world coordinates; vertices are those of the model's file
};

/// Whole circles, and arcs of half a turn or more: those that drawings give centre lines. Left out is what a transform
/// with unequal scales made an ellipse.
std::vector<PlacedCircle> find_placed_circles(const World& world, double crease_angle = 30);

}  // namespace epura
