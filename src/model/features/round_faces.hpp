// SPDX-License-Identifier: Apache-2.0
// Finds the round faces of a part, limited to what remains of them in the world.
#pragma once

#include <vector>

#include "surfaces/limits.hpp"
#include "world/placed_part.hpp"

namespace epura::features {

/// A cylinder, cone, sphere or torus. Heights are along its axis from its origin.
struct RoundFace {
  int number;  ///< number of the face in the part
  surfaces::PartFace face;
  std::vector<int> vertices;  ///< vertices of the remainder in the world, ascending
  double from, to;            ///< heights of the ends of the remainder; unused for a sphere
  double reach;               ///< greatest distance of its vertices from the axis
  double sweep_left;          ///< remainder of `face.sweep` after a cut, degrees
  Vec3 middle{0};             ///< for an arc: direction from the axis to its middle
  bool cut = false;           ///< a plane cuts it

  [[nodiscard]] Vec3 at(double height) const { return face.surface.origin + height * face.surface.axis; }
  [[nodiscard]] double radius_at(double height) const;
  [[nodiscard]] bool is_whole() const { return face.sweep >= surfaces::whole_turn; }
  /// Whether the axis is still meaningful: at least half of the face remains.
  [[nodiscard]] bool has_its_axis() const { return sweep_left >= face.sweep / 2 - 1; }
};

/// Returns the round faces of one model in order of their numbers, without those that a cut removes.
std::vector<RoundFace> find_round_faces(const world::World& world, int model, const world::PlacedPart& part);

}  // namespace epura::features
