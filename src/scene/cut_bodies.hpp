// SPDX-License-Identifier: Apache-2.0
// Which of a model's bodies are solid, which are cavities, and which are not closed.
#pragma once

#include <optional>
#include <vector>

#include "scene/cut_outline.hpp"

namespace epura::scene {

/// A model of a world, and what a plane cuts of it.
struct CutModel {
  const World& world;
  int model;
  const CutMesh& cut;
  CutPlaces places;
  const PlaneFrame& frame;
};

/// For each body the body to whose material it belongs: itself, or, for a cavity, the one around it. A cavity is a
/// surface of its own inside another that runs the other way round. Only bodies that the cut meets are examined, by
/// their closed outlines. `is_open` is what open_bodies says.
std::vector<int> material_of(const CutModel& model, const std::vector<char>& is_open);

/// By body, whether there is an edge at which an odd number of its triangles meet.
std::vector<char> open_bodies(const mesh::Mesh& mesh);

}  // namespace epura::scene
