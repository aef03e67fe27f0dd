// SPDX-License-Identifier: Apache-2.0
// Exploded views: bodies moved apart, with lines from their places in the assembly.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "scene/description.hpp"
#include "world/world.hpp"

namespace epura::world {

/// A line from the middle of a moved body at its place in the assembly, or in the body that holds it, to where that is
/// now: on the axis of its largest cylinder if the body moves along that axis.
using Trace = std::array<Vec3, 2>;

struct ExplodedWorld {
  World world;  ///< vertices and triangles keep their numbers; vertices that bodies shared have copies at the end
  std::vector<Trace> traces;
};

/// Moves bodies and models apart. Several moves of one body add up. `names` are those of the models. A move with a
/// factor goes along the axis of the largest cylinder of the body, otherwise along the axis of the world in which the
/// body is farthest from the largest one; its length is the factor times the distance between the middles of both along
/// that axis. The largest body stays; of several, the one farthest along -x, -y, -z. Bodies that hold others come apart
/// in order (world/explosion_order.hpp). Bodies that do not move along the axis of their largest cylinder have a trace
/// only if that is requested. Throws Error{input} for patterns that match no body.
ExplodedWorld explode_world(const World& world, std::span<const scene::ExplodeDescription> moves,
                            std::span<const std::string> names);

/// Throws Error{input} for moves that have neither a vector nor a factor, or both, and for views that do not exist.
void expect_sound_moves(const scene::SceneDescription& scene);

}  // namespace epura::world
