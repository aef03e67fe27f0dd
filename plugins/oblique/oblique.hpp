// SPDX-License-Identifier: Apache-2.0
// Common code of the oblique projections of the front face.
#pragma once

#include <epura/projection_plugin.hpp>

/// A point y behind the plane is drawn at (x + ratio cos(angle) y, z + ratio sin(angle) y). The angle between
/// projectors and plane has the cotangent `ratio`.
inline epura::plugin::View oblique(const epura::plugin::Scene& scene, double angle, double ratio) {
  const double a = epura::plugin::radians(angle);
  return {.point = scene.centre(),
          .normal = {0, -1, 0},
          .up = {0, 0, 1},
          .projector = {ratio * epura::plugin::portable_cos(a), -1, ratio * epura::plugin::portable_sin(a)}};
}
