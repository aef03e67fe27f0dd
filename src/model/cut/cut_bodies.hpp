// SPDX-License-Identifier: Apache-2.0
// Determines which of a model's bodies are solid, which are cavities, and which are not closed.
#pragma once

#include <optional>
#include <vector>

#include "cut/cut_outline.hpp"

namespace epura::cut {

/// A model of a world, and its cut by a plane.
struct CutModel {
  const world::World& world;
  int model;
  const CutMesh& cut;
  CutPlaces places;
  const PlaneFrame& frame;
};

/// Returns for each body the body to whose material it belongs: itself or, for a cavity, the body around it. A cavity
/// is a separate surface inside another one, with opposite orientation. Only bodies that the plane cuts are examined,
/// by their closed outlines. `is_open` is the result of open_bodies.
std::vector<int> material_of(const CutModel& model, const std::vector<char>& is_open);

/// Returns for each body whether it has an edge at which an odd number of its triangles meet.
std::vector<char> open_bodies(const mesh::Mesh& mesh);

}  // namespace epura::cut
