// SPDX-License-Identifier: Apache-2.0
// The order in which bodies that hold each other come apart.
#pragma once

#include <optional>
#include <vector>

#include "world/world.hpp"

namespace epura::world {

/// Whether a shaft may be in a hole, by their radii: with play, or in a tapped one.
bool may_be_in(double shaft, double hole);

/// A body of a model, and its move in an exploded view.
struct MovedBody {
  Box box{};
  Vec3 axis{0.0};     ///< of its largest cylinder; zero if there is none
  Vec3 on_axis{0.0};  ///< a point of that axis
  double radius = 0;  ///< of that cylinder
  Vec3 move{0.0};
  Vec3 start{0.0};               ///< the move of what holds it, from which its trace begins
  double factor = 0;             ///< of its move outwards; 0: it has none, or a given one
  std::optional<bool> traced{};  ///< as given
};

using Bodies = std::vector<std::vector<MovedBody>>;  // by model

/// Corrects the moves outwards of bodies with a cylinder in holes of others, such as bolts and rods, and of what is on
/// them, such as washers and nuts. A pin leaves on the side of its head, or opposite to what is on it, beyond all that
/// it goes through; what is on its other end leaves on that side. A pin that holds bodies at both ends stays where its
/// holes go, and these leave beyond its ends. What follows one another along the axis is apart by at least the diameter
/// of the pin times the factor.
void order_by_holes(const World& world, Bodies& bodies);

}  // namespace epura::world
