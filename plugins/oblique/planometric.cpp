// SPDX-License-Identifier: Apache-2.0
// Planometric projection: the plan keeps its true shape, rotated on the page; heights are drawn vertically.
#include <epura/projection_plugin.hpp>

using namespace epura::plugin;

struct Planometric {
  static constexpr auto name = "planometric";
  static constexpr auto family = "oblique";
  static constexpr auto summary = "plan true and turned, heights straight up";
  static constexpr auto reference = "ISO 5456-3";
  static constexpr std::array parameters{
      number("angle", "deg", "clockwise rotation of the plan", 45, -360, 360),
      number("height", "1", "length of a unit of height in the drawing: 1, or 0.6667 in the shortened form", 1, 0, 10),
  };

  static View project(const Scene& scene, double angle, double height) {
    const double a = radians(angle);
    const Vec3 up{-portable_sin(a), portable_cos(a), 0};
    return {.point = scene.centre(), .normal = {0, 0, 1}, .up = up, .projector = Vec3{0, 0, 1} - height * up};
  }
};
EPURA_PROJECTION(Planometric)
