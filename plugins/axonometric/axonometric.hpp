// SPDX-License-Identifier: Apache-2.0
// Common code of the axonometric projections.
#pragma once

#include <epura/projection_plugin.hpp>

inline constexpr epura_parameter foreshortened_parameter = epura::plugin::choice(
    "foreshortened", "true: as projected; false: enlarged, so that the longest axis is true", "false|true", 1);

inline constexpr epura_parameter corner_parameter = epura::plugin::choice(
    "from", "the corner of the model that is nearest to the viewer", "right-front|left-front|left-back|right-back", 0);
inline constexpr epura_parameter below_parameter =
    epura::plugin::choice("below", "true: seen from below", "false|true", 0);

/// `direction`, which is that of the right front corner seen from above, reflected to another corner: an index of
/// `corner_parameter`.
inline epura::plugin::Vec3 towards_corner(epura::plugin::Vec3 direction, int corner, bool below) {
  return {corner == 1 || corner == 2 ? -direction.x : direction.x, corner >= 2 ? -direction.y : direction.y,
          below ? -direction.z : direction.z};
}

/// The orthographic view from `direction`. An axis whose direction has the cosine c with the normal is drawn with the
/// length sqrt(1 - c^2); unless foreshortened, the drawing is enlarged until the longest of the three has the length 1,
/// as is usual in drawing by hand.
inline epura::plugin::View axonometric(const epura::plugin::Scene& scene, epura::plugin::Vec3 direction,
                                       bool foreshortened) {
  const epura::plugin::Vec3 n = epura::plugin::unit(direction);
  const double min_cosine = std::min({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  return {.point = scene.centre(),
          .normal = n,
          .up = {0, 0, 1},
          .projector = n,
          .scale = foreshortened ? 1 : 1 / std::sqrt(1 - min_cosine * min_cosine)};
}
