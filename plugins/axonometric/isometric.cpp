// SPDX-License-Identifier: Apache-2.0
// Isometric projection: the three axes at 120 degrees on the page and at the same scale.
#include "axonometric.hpp"

using namespace epura::plugin;

struct Isometric {
  static constexpr auto name = "isometric";
  static constexpr auto family = "axonometric";
  static constexpr auto summary = "axes at equal angles; factor 0.8165, or 1:1:1 when not foreshortened";
  static constexpr auto reference = "ISO 5456-3";
  static constexpr std::array parameters{foreshortened_parameter, corner_parameter, below_parameter};

  static View project(const Scene& scene, bool foreshortened, int corner, bool below) {
    return axonometric(scene, towards_corner({1, -1, 1}, corner, below), foreshortened);
  }
};
EPURA_PROJECTION(Isometric)
