// SPDX-License-Identifier: Apache-2.0
#include "world/placed_circles.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/portable_math.hpp"

namespace epura::world {

namespace {

double sweep_of(const World& world, int model, const mesh::MeshCircle& circle) {
  const auto spoke = [&](std::size_t i) {
    return world.points[world.first_vertex[model] + circle.vertices[i]] - circle.centre;
  };
  double sweep = 0;
  for (std::size_t i = 1; i < circle.vertices.size(); ++i)
    sweep += portable_atan2(glm::length(glm::cross(spoke(i - 1), spoke(i))), glm::dot(spoke(i - 1), spoke(i)));
  return sweep;
}

}  // namespace

std::vector<mesh::MeshCircle> find_circles(const World& world, int model, double crease_angle) {
  const int first = world.first_triangle[model], count = world.first_triangle[model + 1] - first;
  const auto triangles =
      std::span(world.triangles).subspan(static_cast<std::size_t>(first), static_cast<std::size_t>(count));
  return mesh::find_circles(
      mesh::PlacedMesh{*world.models[model].mesh, world.points, triangles, world.first_vertex[model]}, crease_angle);
}

std::vector<mesh::MeshCircle> find_round_rims(const World& world, int model, double crease_angle) {
  constexpr double half_turn = std::numbers::pi * (1 - 1e-6);
  std::vector<mesh::MeshCircle> circles = find_circles(world, model, crease_angle);
  std::erase_if(circles, [&](const mesh::MeshCircle& circle) {
    return !circle.whole && sweep_of(world, model, circle) < half_turn;
  });
  return circles;
}

}  // namespace epura::world
