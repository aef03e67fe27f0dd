// SPDX-License-Identifier: Apache-2.0
// Three-point perspective: a tilted plane, so that height converges, too.
#include "perspective.hpp"

using namespace perspective;

struct ThreePoint {
  static constexpr auto name = "three-point";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "width, depth and height converge";
  static constexpr auto reference = "ISO 5456-4";
  static constexpr std::array parameters{
      distance_parameter,
      number("azimuth", "deg", "angle of the eye to the right of the front", 40, -360, 360),
      number("elevation", "deg", "angle of the eye above the horizontal; negative: below", 30, -89, 89),
  };

  static View project(const Scene& scene, double distance, double azimuth, double elevation) {
    require_turned(azimuth);
    if (std::abs(elevation) < 1)
      throw std::invalid_argument("elevation must be 1 deg or more, up or down: at 0 the verticals stay vertical");
    const Vec3 n = towards_viewer(azimuth, elevation);
    return {.central = true,
            .point = scene.centre(),
            .normal = n,
            .up = {0, 0, 1},
            .projector = scene.centre() + distance * scene.diagonal() * n};
  }
};
EPURA_PROJECTION(ThreePoint)
