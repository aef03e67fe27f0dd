// SPDX-License-Identifier: Apache-2.0
// Groups the round faces of a part about their common axes.
#pragma once

#include <vector>

#include "features/round_faces.hpp"
#include "world/world.hpp"

namespace epura::features {

/// A model whose faces are recognised, and its round faces.
struct RoundPart {
  const world::World& world;
  int model;
  world::PlacedPart part;
  std::vector<RoundFace> faces;
  std::vector<int> place_of_face;          ///< index of each face of the part among `faces`, -1 for others
  std::vector<std::vector<int>> vertices;  ///< in the file, by round face

  [[nodiscard]] const std::vector<surfaces::PartBorder>& borders() const {
    return world.models[static_cast<std::size_t>(model)].part->borders;
  }
};

RoundPart make_round_part(const world::World& world, int model, world::PlacedPart part);

inline Vec3 middle_of(const RoundFace& round) { return round.at(0.5 * (round.from + round.to)); }

/// Groups of faces about one axis, each ascending, without those that are used (1, by round face). Only whole tori have
/// an axis.
std::vector<std::vector<int>> coaxial_groups(const RoundPart& of, const std::vector<char>& used);

/// The faces of such a group whose axis is drawn, with the spherical ends adjacent to them; ascending. The arcs of a
/// cylinder must sweep half a turn together, and not be the sides of grooves or letters that run along an arc.
std::vector<int> faces_with_axis(const RoundPart& of, const std::vector<int>& group);

}  // namespace epura::features
