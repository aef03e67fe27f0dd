// SPDX-License-Identifier: Apache-2.0
// Round faces of a part, as far as they are in the world.
#pragma once

#include <vector>

#include "scene/placed_part.hpp"

namespace epura::scene {

/// A cylinder, cone, sphere or torus. Heights are along its axis from its origin.
struct RoundFace {
  int number;  ///< of the face of the part
  features::PartFace face;
  std::vector<int> vertices;  ///< of the world, ascending: of what a cut has left
  double from, to;            ///< heights of its ends, likewise; none of a sphere
  double reach;               ///< of its vertices, farthest from the axis
  double sweep_left;          ///< degrees: what a cut has left of `face.sweep`
  Vec3 middle{0};             ///< of an arc: the direction from the axis to its middle, in the whole
  bool cut = false;           ///< a plane has laid it open

  [[nodiscard]] Vec3 at(double height) const { return face.surface.origin + height * face.surface.axis; }
  [[nodiscard]] double radius_at(double height) const;
  [[nodiscard]] bool is_whole() const { return face.sweep >= 359; }
  /// Whether the axis is still meaningful: half of the face is left.
  [[nodiscard]] bool has_its_axis() const { return sweep_left >= face.sweep / 2 - 1; }
};

/// Of one model, in order of their numbers, without those that a cut has removed.
std::vector<RoundFace> find_round_faces(const World& world, int model, const PlacedPart& part);

}  // namespace epura::scene
