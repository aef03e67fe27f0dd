// SPDX-License-Identifier: Apache-2.0
// The shadow that the sun throws on the ground, as a plan: parallel projection along its rays.
#include <epura/projection_plugin.hpp>

using namespace epura::plugin;

struct Shadow {
  static constexpr auto name = "shadow";
  static constexpr auto family = "sun";
  static constexpr auto summary = "shadow on the ground, seen from above";
  static constexpr auto reference = "M_par onto z = 0 along the rays";
  static constexpr std::array parameters{
      number("azimuth", "deg", "how far to the right of the front the sun stands", 30, -360, 360),
      number("elevation", "deg", "the sun's height above the horizon", 45, 1, 90)};

  static View project(const Scene&, double azimuth, double elevation) {
    View view;
    view.normal = {0, 0, 1};
    view.up = {0, 1, 0};
    view.projector = towards_viewer(azimuth, elevation);
    return view;
  }
};
EPURA_PROJECTION(Shadow)
