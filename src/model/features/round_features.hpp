// SPDX-License-Identifier: Apache-2.0
// What a designer made of the round faces of one model: shafts, arcs, rounded edges, balls, cones and chamfers.
#pragma once

#include <vector>

#include "features/part_features.hpp"
#include "features/round_faces.hpp"

namespace epura::features {

/// The round faces of a model.
struct RoundFaces {
  const world::World& world;
  int model;
  const world::PlacedPart& part;
  std::vector<RoundFace> faces;

  [[nodiscard]] const world::Placed& placed() const { return world.models[static_cast<std::size_t>(model)]; }
};

/// Full cylinders with the material inside, then cylinders of either kind that are interrupted.
std::vector<CylinderFeature> shafts_of(const RoundFaces& of);

/// Parts of cylinders that are no ends of slots, and the only ones of their cylinder.
std::vector<ArcFeature> arcs_of(const RoundFaces& of, const std::vector<SlotFeature>& slots);

/// Tori of which slots leave at least half a turn.
std::vector<RoundFeature> rounds_of(const RoundFaces& of);

std::vector<BallFeature> balls_of(const RoundFaces& of);

struct Cones {
  std::vector<ConeFeature> chamfers, others;  ///< as in PartFeatures
};
Cones cones_of(const RoundFaces& of);

}  // namespace epura::features
