// SPDX-License-Identifier: Apache-2.0
// Frustum: eye, reference point, up-vector and the view frustum: left, right, bottom and top on a plane at distance d
// from the eye, near and far planes. As in OpenGL, d is the near distance unless given.
#include "../upright.hpp"
#include "perspective.hpp"

using namespace perspective;

struct Frustum {
  static constexpr auto name = "frustum";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "a pyramid frustum from an eye: left, right, bottom, top, near, far";
  static constexpr auto reference = "Martha and Gattass, transformations for viewing in 3D: [F] = [N][P]";
  static constexpr double any = unlimited;
  static constexpr std::array parameters{
      vector<3>("eye", "model units", "centre of projection"),
      vector<3>("ref", "model units", "point looked at; the model's centre unless given"),
      vector<3>("vup", "1", "upward direction of the view; seen end-on, z stands for that of top or bottom", {0, 0, 1}),
      number("l", "model units", "left edge on the plane", from_box, -any, any),
      number("r", "model units", "right edge on the plane", from_box, -any, any),
      number("b", "model units", "bottom edge on the plane", from_box, -any, any),
      number("t", "model units", "top edge on the plane", from_box, -any, any),
      number("n", "model units", "distance of the near plane from the eye", from_box, 0, any),
      number("f", "model units", "distance of the far plane from the eye", from_box, 0, any),
      number("d", "model units", "distance of the projection plane from the eye; n unless given", from_box, 0, any),
  };

  static View project(const Scene& scene, Vec3 eye, Vec3 ref, Vec3 vup, double l, double r, double b, double t,
                      double n, double f, double d) {
    ref = given_or(ref, scene.centre());
    eye = given_or(eye, calm_eye(scene, ref));
    const Vec3 view = unit(sight(eye, ref));
    // Unless given, the planes touch the bounding sphere of the box, and the window contains that sphere.
    const double depth = dot(scene.centre() - eye, view), radius = scene.diagonal() / 2;
    n = given_or(n, std::max(depth - radius, scene.diagonal() / 100));
    f = given_or(f, std::max(depth + radius, 2 * n));
    d = given_or(d, n);
    if (!(n > 0 && f > n && d > 0)) throw std::invalid_argument("distances must satisfy 0 < n < f and 0 < d");
    const double half = d * std::min(1.0, radius / std::sqrt(std::max(depth * depth - radius * radius, 1e-300)));
    const std::array window{given_or(l, -half), given_or(b, -half), given_or(r, half), given_or(t, half)};
    if (!(window[0] < window[2] && window[1] < window[3])) throw std::invalid_argument("l < r and b < t are required");
    return {.central = true,
            .point = eye + d * view,
            .normal = -view,
            .up = upright(vup, -view),
            .projector = eye,
            .window = window,
            .front = d - n,
            .back = d - f};
  }
};
EPURA_PROJECTION(Frustum)
