// SPDX-License-Identifier: Apache-2.0
// Arcs in which a part ends, about an axis that has a place of its own: the eyes of a lever, the ends of a bar. Their
// radius and the distance of their axes give the size of the part, whose overall dimension is auxiliary (ISO 129-1).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "features/turned_part.hpp"
#include "sizes/automatic.hpp"

namespace epura::sheet {

struct RoundEnd {
  Vec3 centre, axis;  ///< the axis is a unit vector
  double radius;
  Vec3 middle;             ///< direction from the centre to the middle of the arc
  double half;             ///< of its sweep, degrees
  int arc;                 ///< its number among the arcs of the features; -1 for a boss
  bool is_tangent = true;  ///< faces beside it go on tangentially

  /// Whether it reaches farther in that direction than its own ends, and thus than the faces beside it.
  [[nodiscard]] bool bulges(int along, int side) const;
  /// Whether a face that is tangent to it ends it in that direction, at its radius from its centre.
  [[nodiscard]] bool has_side(int along, int side) const;
  /// The place of that face.
  [[nodiscard]] double at_side(int along, int side) const { return centre[along] + (side == 0 ? -radius : radius); }
  /// Whether the models end there along an axis of the world: at its lower end for side 0, at its upper one for 1.
  [[nodiscard]] bool ends_models(int along, int side, const features::Extent& extent) const;
};

using features::FlatEnds;
FlatEnds find_flat_ends(const DimensionSubject& subject);

/// Those of half a turn or more, others around the axis of a hole, others between slopes in which the models end, and
/// bosses in which they do.
std::vector<RoundEnd> find_round_ends(const DimensionSubject& subject, const FlatEnds& flat);

/// Open channels, notches and ends of open slots: cut into the material, of half a turn or more, or with no face beside
/// them that goes on tangentially, so that nothing but a position tells where their axes are.
std::vector<RoundEnd> find_channels(const DimensionSubject& subject);

/// The one at an end of the models along an axis of the world; null if there is none.
const RoundEnd* end_along(std::span<const RoundEnd> ends, int axis, int side, const features::Extent& extent);

}  // namespace epura::sheet
