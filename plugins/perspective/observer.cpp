// SPDX-License-Identifier: Apache-2.0
// Observer: an eye o looks at a point c; a point u appears vertically above c; the picture plane is at distance d.
#include "../upright.hpp"
#include "perspective.hpp"

using namespace perspective;

struct Observer {
  static constexpr auto name = "observer";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "an observer, a point of interest, a point above it, and the picture's distance";
  static constexpr auto reference = "J. Stolfi, Computacao Grafica, 6.1: t = dir(o-c), s, r = s x t, f = o - d t";
  static constexpr std::array parameters{
      vector<3>("o", "model units", "the observer's eye"),
      vector<3>("c", "model units", "point of interest; the model's centre unless given"),
      vector<3>("u", "model units", "a point that appears straight above c"),
      number("d", "model units", "distance of the picture from the eye; that of c unless given", from_box, 0,
             unlimited),
      vector<4>("window", "model units", "min X, min Y, max X, max Y from the foot of the eye; zeros: everything",
                {0, 0, 0, 0}),
  };

  static View project(const Scene& scene, Vec3 o, Vec3 c, Vec3 u, double d, const std::array<double, 4>& window) {
    c = given_or(c, scene.centre());
    o = given_or(o, calm_eye(scene, c));
    u = given_or(u, c + scene.diagonal() * upright({0, 0, 1}, o - c));
    const Vec3 line = sight(o, c);
    d = given_or(d, length(line));
    if (!(d > 0)) throw std::invalid_argument("d must be more than 0");
    return {
        .central = true, .point = o + d * unit(line), .normal = -line, .up = u - c, .projector = o, .window = window};
  }
};
EPURA_PROJECTION(Observer)
