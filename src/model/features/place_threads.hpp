// SPDX-License-Identifier: Apache-2.0
// Finds the cylinders of parts to which the threads of a scene belong.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/description.hpp"
#include "world/placed_part.hpp"
#include "world/world.hpp"

namespace epura::features {

/// A cone that continues a cylinder: a chamfer or countersink.
struct Continuation {
  int face;         ///< of the part
  double height;    ///< along the axis
  double widening;  ///< growth of its radius per length, away from the cylinder; negative if it narrows
};

/// Returns the cone around the axis of a cylinder that begins at one of its ends; nothing if there is none.
std::optional<Continuation> continuation_of(const world::PlacedPart& part, int cylinder, bool at_high_end);

/// Sets the threads of the models. `positions` are those at which the descriptions are, in their order. Throws
/// Error{input} that locates the description: for threads that ISO 261 does not have, positions without a hole or
/// shaft, cylinders of which the diameter does not suit the thread, or that have another one, and for lengths that they
/// do not have.
void place_threads(world::World& world, std::span<const scene::ThreadDescription> threads,
                   std::span<const Vec3> positions);

/// The depth of a thread that begins at the end of its cylinder which is nearer to one point on its axis, and ends at
/// another; nothing if no cylinder with this radius is around that.
std::optional<double> depth_of_thread(const world::World& world, double radius, const Vec3& begin, const Vec3& end);

}  // namespace epura::features
