// SPDX-License-Identifier: Apache-2.0
// Bottom view: looks along +z; the front of the model is up on the page.
#include "orthographic.hpp"

using namespace epura::plugin;

struct Bottom {
  static constexpr auto name = "bottom";
  static constexpr auto family = "orthographic";
  static constexpr auto summary = "seen from below, along +z";
  static constexpr auto reference = "ISO 5456-2";
  static constexpr auto parameters = no_parameters;

  static View project(const Scene& scene) { return orthographic(scene, {0, 0, -1}, {0, -1, 0}); }
};
EPURA_PROJECTION(Bottom)
