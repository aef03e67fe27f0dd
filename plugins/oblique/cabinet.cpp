// SPDX-License-Identifier: Apache-2.0
// Cabinet projection: the front face keeps its true shape, depth recedes at half its length.
#include "oblique.hpp"

using namespace epura::plugin;

struct Cabinet {
  static constexpr auto name = "cabinet";
  static constexpr auto family = "oblique";
  static constexpr auto summary = "front face true, depth slanted at half length";
  static constexpr auto reference = "ISO 5456-3";
  static constexpr std::array parameters{
      number("angle", "deg", "angle of receding lines from the horizontal", 45, -360, 360)};

  static View project(const Scene& scene, double angle) { return oblique(scene, angle, 0.5); }
};
EPURA_PROJECTION(Cabinet)
