// SPDX-License-Identifier: Apache-2.0
// Common code of the orthographic views.
#pragma once

#include <epura/projection_plugin.hpp>

/// Projectors perpendicular to the plane: the view from `direction`, with `up` up the page.
inline epura::plugin::View orthographic(const epura::plugin::Scene& scene, epura::plugin::Vec3 direction,
                                        epura::plugin::Vec3 up) {
  return {.point = scene.centre(), .normal = direction, .up = up, .projector = direction};
}
