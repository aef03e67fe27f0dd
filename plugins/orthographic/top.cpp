// SPDX-License-Identifier: Apache-2.0
// Top view: looks along -z; the back of the model is up on the page.
#include "orthographic.hpp"

using namespace epura::plugin;

struct Top {
  static constexpr auto name = "top";
  static constexpr auto family = "orthographic";
  static constexpr auto summary = "seen from above, along -z";
  static constexpr auto reference = "ISO 5456-2";
  static constexpr auto parameters = no_parameters;

  static View project(const Scene& scene) { return orthographic(scene, {0, 0, 1}, {0, 1, 0}); }
};
EPURA_PROJECTION(Top)
