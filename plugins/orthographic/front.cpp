// SPDX-License-Identifier: Apache-2.0
// Front view: looks along +y.
#include "orthographic.hpp"

using namespace epura::plugin;

struct Front {
  static constexpr auto name = "front";
  static constexpr auto family = "orthographic";
  static constexpr auto summary = "seen from the front, along +y";
  static constexpr auto reference = "ISO 5456-2";
  static constexpr auto parameters = no_parameters;

  static View project(const Scene& scene) { return orthographic(scene, {0, -1, 0}, {0, 0, 1}); }
};
EPURA_PROJECTION(Front)
