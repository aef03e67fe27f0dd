// SPDX-License-Identifier: Apache-2.0
// Arcs in which a part ends, about an axis that has a place of its own: the eyes of a lever, the ends of a bar. Their
// radius and the distance of their axes give the size of the part, whose overall dimension is auxiliary (ISO 129-1).
#pragma once

#include <span>
#include <vector>

#include "sheet/dimensions/automatic.hpp"

namespace epura::sheet {

struct RoundEnd {
  Vec3 centre, axis;  ///< the axis is a unit vector
  double radius;
  Vec3 middle;  ///< direction from the centre to the middle of the arc
  double half;  ///< of its sweep, degrees
  int arc;      ///< its number among the arcs of the features

  /// Whether it reaches farther in that direction than its own ends, and thus than the faces beside it.
  [[nodiscard]] bool bulges(int along, int side) const;
  /// Whether the models end there along an axis of the world: at its lower end for side 0, at its upper one for 1.
  [[nodiscard]] bool ends_models(int along, int side, const features::Extent& extent) const;
};

/// Those of half a turn or more, and others around the axis of a hole.
std::vector<RoundEnd> find_round_ends(const features::PartFeatures& features);

/// Numbers of the arcs that are open channels or notches: cut into the material, and no face beside them goes on
/// tangentially, so that nothing but a position tells where their axes are.
std::vector<int> find_channels(const DimensionSubject& subject);

/// The one at an end of the models along an axis of the world; null if there is none.
const RoundEnd* end_along(std::span<const RoundEnd> ends, int axis, int side, const features::Extent& extent);

}  // namespace epura::sheet
