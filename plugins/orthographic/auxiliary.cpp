// SPDX-License-Identifier: Apache-2.0
// Auxiliary view: shows an inclined face in true shape, viewed along its normal.
#include "../upright.hpp"
#include "orthographic.hpp"

using namespace epura::plugin;

struct Auxiliary {
  static constexpr auto name = "auxiliary";
  static constexpr auto family = "orthographic";
  static constexpr auto summary = "orthographic view from any direction";
  static constexpr auto reference = "ISO 5456-2";
  static constexpr std::array parameters{
      vector<3>("direction", "1", "from the model towards the viewer", {1, -1, 0}),
      vector<3>("up", "1", "upward direction of the view; seen end-on, z stands for that of top or bottom", {0, 0, 1}),
  };

  static View project(const Scene& scene, Vec3 direction, Vec3 up) {
    return orthographic(scene, direction, upright(up, direction));
  }
};
EPURA_PROJECTION(Auxiliary)
