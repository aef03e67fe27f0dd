// SPDX-License-Identifier: Apache-2.0
// What the axonometric projections share.
#pragma once

#include <epura/projection_plugin.hpp>

inline constexpr epura_parameter foreshortened_parameter = epura::plugin::choice(
    "foreshortened", "true: as projected; false: enlarged, so that the longest axis is true", "false|true", 1);

/// The orthographic view from `direction`. An axis at cosine c to the normal is drawn sqrt(1 - c^2) long; unless
/// foreshortened, the drawing is enlarged until the longest of the three is 1, as is the custom by hand.
inline epura::plugin::View axonometric(const epura::plugin::Scene& scene, epura::plugin::Vec3 direction,
                                       bool foreshortened) {
  const epura::plugin::Vec3 n = epura::plugin::unit(direction);
  const double least_cosine = std::min({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
  return {.point = scene.centre(),
          .normal = n,
          .up = {0, 0, 1},
          .projector = n,
          .scale = foreshortened ? 1 : 1 / std::sqrt(1 - least_cosine * least_cosine)};
}
