// SPDX-License-Identifier: Apache-2.0
// The same drawing by three arithmetics, for comparison: only the map from space to the page differs.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "view/projected_scene.hpp"
#include "world/world.hpp"

namespace epura::laboratory {

enum class Arithmetic {
  single,    ///< 32-bit floats: coordinates, matrix and products, as in graphics hardware
  composed,  ///< doubles: one matrix, composed of VOM and M_per or M_par as printed (seed 003, 3.36, 3.10, 3.20)
  own,       ///< doubles: the re-centred map of view/view_map.hpp
};

inline constexpr std::size_t arithmetics = 3;
inline constexpr std::array<std::string_view, arithmetics> arithmetic_names{"float32", "double", "epura"};

/// A projection and the other data on which the map depends.
struct Camera {
  projection::Projection projection;
  view::ViewLimits limits{};
  double factor = 1;  ///< factor of the composed matrix; the projective map is unchanged
};

/// Maps points by the arithmetic to the coordinates of make_view_map(camera.projection, scene).
UnsetVector<view::Mapped> map_points(std::span<const Vec3> points, const Camera& camera, const Box& scene,
                                     Arithmetic arithmetic);

/// Throws Error{input} if a point leaves the range of the arithmetic, and like project_scene.
view::ProjectedScene view_by(const world::World& world, const Camera& camera, Arithmetic arithmetic);

}  // namespace epura::laboratory
