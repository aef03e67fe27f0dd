// SPDX-License-Identifier: Apache-2.0
// What a designer made of the round faces of one model: shafts, arcs, rounded edges, balls, cones and chamfers.
#pragma once

#include <vector>

#include "design/design_features.hpp"
#include "design/round_faces.hpp"

namespace epura::design {

/// The round faces of a model.
struct RoundFaces {
  const world::World& world;
  int model;
  const world::PlacedPart& part;
  std::vector<RoundFace> faces;

  [[nodiscard]] const world::Placed& placed() const { return world.models[static_cast<std::size_t>(model)]; }
};

/// Full cylinders with the material inside, then cylinders of either kind that are interrupted.
std::vector<DesignCylinder> shafts_of(const RoundFaces& of);

/// Parts of cylinders that are no ends of slots, and the only ones of their cylinder.
std::vector<DesignArc> arcs_of(const RoundFaces& of, const std::vector<DesignSlot>& slots);

/// Tori of which slots leave at least half a turn.
std::vector<DesignRound> rounds_of(const RoundFaces& of);

std::vector<DesignBall> balls_of(const RoundFaces& of);

struct Cones {
  std::vector<DesignCone> chamfers, others;  ///< as in DesignFeatures
};
Cones cones_of(const RoundFaces& of);

}  // namespace epura::design
