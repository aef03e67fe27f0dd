// SPDX-License-Identifier: Apache-2.0
// Two-point perspective: an upright plane rotated against the model, so that verticals remain vertical.
#include "perspective.hpp"

using namespace perspective;

struct TwoPoint {
  static constexpr auto name = "two-point";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "verticals stay vertical, width and depth converge";
  static constexpr auto reference = "ISO 5456-4";
  static constexpr std::array parameters{
      distance_parameter,
      number("azimuth", "deg", "angle of the eye to the right of the front", 40, -360, 360),
      number("above", "diagonals", "height of the eye above the model's centre", 0.25, -1e3, 1e3),
      eye_height_parameter,
  };

  static View project(const Scene& scene, double distance, double azimuth, double above, double eye_height) {
    require_turned(azimuth);
    const Vec3 n = towards_viewer(azimuth, 0);
    return {.central = true,
            .point = scene.centre(),
            .normal = n,
            .up = {0, 0, 1},
            .projector = at_height(scene.centre() + scene.diagonal() * (distance * n + Vec3{0, 0, above}), eye_height)};
  }
};
EPURA_PROJECTION(TwoPoint)
