// SPDX-License-Identifier: Apache-2.0
// One-point perspective: the plane contains the front of the model's box, which is drawn in true size; depth converges.
#include "perspective.hpp"

using namespace perspective;

struct OnePoint {
  static constexpr auto name = "one-point";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "front face true, depth converging to one point";
  static constexpr auto reference = "ISO 5456-4";
  static constexpr std::array parameters{
      distance_parameter,
      number("right", "diagonals", "distance of the eye to the right of the model's centre", 0.5, -1e3, 1e3),
      number("above", "diagonals", "height of the eye above the model's centre", 0.4, -1e3, 1e3),
      eye_height_parameter,
  };

  static View project(const Scene& scene, double distance, double right, double above, double eye_height) {
    const Vec3 centre = scene.centre();
    return {.central = true,
            .point = {centre.x, scene.least.y, centre.z},
            .normal = {0, -1, 0},
            .up = {0, 0, 1},
            .projector = at_height(centre + scene.diagonal() * Vec3{right, -distance, above}, eye_height)};
  }
};
EPURA_PROJECTION(OnePoint)
