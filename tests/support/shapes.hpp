// SPDX-License-Identifier: Apache-2.0
// The meshes and views of the stability study, drawn by epura's own arithmetic.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "mesh/build.hpp"
#include "study/stability/lab.hpp"
#include "study/stability/shapes.hpp"

namespace epura::test {

using stability::box;
using stability::fan;
using stability::from_above;
using stability::mesh_of;
using stability::moebius;
using stability::orthographic;
using stability::perspective;
using stability::plate;
using stability::Point;
using stability::Result;
using stability::revolved;
using stability::Shape;
using stability::triangulated_cube;
using stability::world_of;

inline Result draw(World world, const Projection& projection, const EdgeOptions& options = {},
                   const ViewLimits& limits = {}) {
  return stability::Lab().draw(std::move(world), {projection, limits}, options);
}

/// Hidden spans of a straight line that belongs to no mesh.
inline Spans hidden_of_line(const World& world, const Projection& projection, const Vec3& from, const Vec3& to) {
  return stability::Lab().hidden_of_line(world, projection, from, to).spans;
}

}  // namespace epura::test
