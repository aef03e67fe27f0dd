// SPDX-License-Identifier: Apache-2.0
// Dimetric projection: width and height at the same scale, depth at half of it.
#include "axonometric.hpp"

using namespace epura::plugin;

struct Dimetric {
  static constexpr auto name = "dimetric";
  static constexpr auto family = "axonometric";
  static constexpr auto summary =
      "width at 7.181, depth at 41.410 degrees and half as long: 1:1/2:1 if not foreshortened";
  static constexpr auto reference = "ISO 5456-3";
  static constexpr std::array parameters{foreshortened_parameter, corner_parameter, below_parameter};

  // Factors in the ratio 2:1:2 whose squares sum to 2: squares 8/9, 2/9, 8/9, hence squared cosines 1/9, 7/9, 1/9.
  static View project(const Scene& scene, bool foreshortened, int corner, bool below) {
    return axonometric(scene, towards_corner({1, -std::sqrt(7.0), 1}, corner, below), foreshortened);
  }
};
EPURA_PROJECTION(Dimetric)
