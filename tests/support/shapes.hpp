// SPDX-License-Identifier: Apache-2.0
// The meshes and views of the laboratory, drawn by epura's own arithmetic.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "laboratory/lab.hpp"
#include "laboratory/shapes.hpp"
#include "mesh/build.hpp"

namespace epura::test {

using laboratory::box;
using laboratory::cube_with_a_cavity;
using laboratory::fan;
using laboratory::fine_cube;
using laboratory::four_boxes;
using laboratory::from_above;
using laboratory::frustum;
using laboratory::klein_bottle;
using laboratory::mesh_of;
using laboratory::moebius;
using laboratory::orthographic;
using laboratory::perspective;
using laboratory::plate;
using laboratory::Point;
using laboratory::recognised;
using laboratory::Result;
using laboratory::revolved;
using laboratory::Shape;
using laboratory::sombrero;
using laboratory::touching_boxes;
using laboratory::triangulated_cube;
using laboratory::uv_sphere;
using laboratory::world_of;

inline Result draw(world::World world, const projection::Projection& projection, const edges::EdgeOptions& options = {},
                   const view::ViewLimits& limits = {}) {
  return laboratory::Lab().draw(std::move(world), {projection, limits}, options);
}

/// Hidden spans of a straight line that belongs to no mesh.
inline visibility::Spans hidden_of_line(const world::World& world, const projection::Projection& projection,
                                        const Vec3& from, const Vec3& to) {
  return laboratory::Lab().hidden_of_line(world, projection, from, to).spans;
}

}  // namespace epura::test
