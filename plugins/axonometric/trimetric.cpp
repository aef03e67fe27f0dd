// SPDX-License-Identifier: Apache-2.0
// Trimetric projection: given directions of width and depth on the page, which determine three different scales.
#include "axonometric.hpp"

using namespace epura::plugin;

struct Trimetric {
  static constexpr auto name = "trimetric";
  static constexpr auto family = "axonometric";
  static constexpr auto summary = "width and depth at chosen angles from the horizontal";
  static constexpr auto reference = "ISO 5456-3";
  static constexpr std::array parameters{
      number("x-angle", "deg", "angle of the width axis below the horizontal", 15, 1, 88),
      number("y-angle", "deg", "angle of the depth axis above the horizontal; the sum must be below 90", 35, 1, 88),
      foreshortened_parameter,
      corner_parameter,
      below_parameter,
  };

  // With azimuth A and elevation E, the axes appear at tan x = tan A sin E and tan y = sin E / tan A.
  static View project(const Scene& scene, double x_angle, double y_angle, bool foreshortened, int corner, bool below) {
    if (x_angle + y_angle > 89) throw std::invalid_argument("the sum of x-angle and y-angle must be at most 89 deg");
    const double x = portable_tan(radians(x_angle)), y = portable_tan(radians(y_angle));
    const double sine = std::sqrt(x * y), cosine = std::sqrt(1 - x * y);
    const double azimuth = std::atan(std::sqrt(x / y));
    const Vec3 direction{portable_sin(azimuth) * cosine, -portable_cos(azimuth) * cosine, sine};
    return axonometric(scene, towards_corner(direction, corner, below), foreshortened);
  }
};
EPURA_PROJECTION(Trimetric)
