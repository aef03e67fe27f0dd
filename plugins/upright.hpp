// SPDX-License-Identifier: Apache-2.0
// The upward direction of views whose normal is free.
#pragma once

#include <epura/projection_plugin.hpp>

/// The upward direction wanted, for a plane with this normal, of any length. Where z is wanted, the default, but is
/// seen end-on, that of the top or bottom view.
inline epura::plugin::Vec3 upright(epura::plugin::Vec3 wanted, epura::plugin::Vec3 normal) {
  constexpr double min_sine = 1e-9;  // of the angle between both; the host refuses less
  const bool is_z = wanted.x == 0 && wanted.y == 0 && wanted.z > 0;
  if (!is_z || std::hypot(normal.x, normal.y) >= min_sine * length(normal)) return wanted;
  return {0, normal.z > 0 ? 1.0 : -1.0, 0};
}
