// SPDX-License-Identifier: Apache-2.0
// Look-at: the camera model with eye, reference point and up-vector. The plane passes through the reference point, so
// that lengths are true there. Draws everything, a field of view, or a window around the reference point.
#include "../upright.hpp"
#include "perspective.hpp"

using namespace perspective;

struct LookAt {
  static constexpr auto name = "look-at";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "eye and reference point";
  static constexpr auto reference = "Martha and Gattass, transformations for viewing in 3D: [C] = [R][T]";
  static constexpr std::array parameters{
      vector<3>("eye", "model units", "centre of projection"),
      vector<3>("ref", "model units", "point looked at; the model's centre unless given"),
      vector<3>("vup", "1", "upward direction of the view; seen end-on, z stands for that of top or bottom", {0, 0, 1}),
      number("fovy", "deg", "vertical field of view; 0: everything", 0, 0, 170),
      number("aspect", "1", "width over height of the field of view", 1, 1e-3, 1e3),
      vector<4>("window", "model units", "min u, min v, max u, max v; zeros: everything", {0, 0, 0, 0}),
  };

  static View project(const Scene& scene, Vec3 eye, Vec3 ref, Vec3 vup, double fovy, double aspect,
                      const std::array<double, 4>& window) {
    ref = given_or(ref, scene.centre());
    eye = given_or(eye, calm_eye(scene, ref));
    const Vec3 line = sight(eye, ref);
    View view{
        .central = true, .point = ref, .normal = -line, .up = upright(vup, -line), .projector = eye, .window = window};
    if (fovy > 0) {
      if (window != std::array<double, 4>{}) throw std::invalid_argument("give fovy or window, not both");
      const double v = length(line) * portable_tan(radians(fovy) / 2), u = aspect * v;
      view.window = {-u, -v, u, v};
    } else if (aspect != 1) {
      throw std::invalid_argument("aspect needs fovy");
    }
    return view;
  }
};
EPURA_PROJECTION(LookAt)
