// SPDX-License-Identifier: Apache-2.0
// Left view: shows the left side, looks along +x.
#include "orthographic.hpp"

using namespace epura::plugin;

struct Left {
  static constexpr auto name = "left";
  static constexpr auto family = "orthographic";
  static constexpr auto summary = "seen from the left, along +x";
  static constexpr auto reference = "ISO 5456-2";
  static constexpr auto parameters = no_parameters;

  static View project(const Scene& scene) { return orthographic(scene, {-1, 0, 0}, {0, 0, 1}); }
};
EPURA_PROJECTION(Left)
