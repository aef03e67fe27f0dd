// SPDX-License-Identifier: Apache-2.0
// Cavalier projection: the front face keeps its true shape, depth recedes at its true length.
#include "oblique.hpp"

using namespace epura::plugin;

struct Cavalier {
  static constexpr auto name = "cavalier";
  static constexpr auto family = "oblique";
  static constexpr auto summary = "front face true, depth slanted at full length";
  static constexpr auto reference = "ISO 5456-3";
  static constexpr std::array parameters{
      number("angle", "deg", "angle of receding lines from the horizontal", 45, -360, 360)};

  static View project(const Scene& scene, double angle) { return oblique(scene, angle, 1); }
};
EPURA_PROJECTION(Cavalier)
