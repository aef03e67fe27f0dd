// SPDX-License-Identifier: Apache-2.0
// Right view: shows the right side, looks along -x.
#include "orthographic.hpp"

using namespace epura::plugin;

struct Right {
  static constexpr auto name = "right";
  static constexpr auto family = "orthographic";
  static constexpr auto summary = "seen from the right, along -x";
  static constexpr auto reference = "ISO 5456-2";
  static constexpr auto parameters = no_parameters;

  static View project(const Scene& scene) { return orthographic(scene, {1, 0, 0}, {0, 0, 1}); }
};
EPURA_PROJECTION(Right)
