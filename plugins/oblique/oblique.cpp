// SPDX-License-Identifier: Apache-2.0
// Oblique projection: the front face keeps its true shape, depth recedes at a chosen angle and length.
#include "oblique.hpp"

using namespace epura::plugin;

struct Oblique {
  static constexpr auto name = "oblique";
  static constexpr auto family = "oblique";
  static constexpr auto summary = "front face true, depth slanted at any angle and ratio";
  static constexpr auto reference = "ISO 5456-3";
  static constexpr std::array parameters{
      number("angle", "deg", "angle of receding lines from the horizontal", 30, -360, 360),
      number("ratio", "1", "length of a unit of depth in the drawing", 0.75, 0, 10),
  };

  static View project(const Scene& scene, double angle, double ratio) { return oblique(scene, angle, ratio); }
};
EPURA_PROJECTION(Oblique)
