// SPDX-License-Identifier: Apache-2.0
// Back view: looks along -y.
#include "orthographic.hpp"

using namespace epura::plugin;

struct Back {
  static constexpr auto name = "back";
  static constexpr auto family = "orthographic";
  static constexpr auto summary = "seen from behind, along -y";
  static constexpr auto reference = "ISO 5456-2";
  static constexpr auto parameters = no_parameters;

  static View project(const Scene& scene) { return orthographic(scene, {0, 1, 0}, {0, 0, 1}); }
};
EPURA_PROJECTION(Back)
