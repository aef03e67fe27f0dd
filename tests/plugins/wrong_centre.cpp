// SPDX-License-Identifier: Apache-2.0
// A perspective whose author measured the centre of projection from the origin instead of the middle of the model.
// It is a projection: only a picture of it shows the mistake (docs/projections.md).
#include <epura/projection_plugin.hpp>

using namespace epura::plugin;

struct WrongCentre {
  static constexpr auto name = "wrong-centre";
  static constexpr auto family = "perspective";
  static constexpr auto summary = "an eye in front of the model, as its author believes";
  static constexpr auto reference = "none";
  static constexpr std::array parameters{
      number("distance", "diagonals", "distance of the eye from the view plane", 2.5, 1, 100)};

  static View project(const Scene& scene, double distance) {
    const Vec3 n{0, -1, 0};
    return {.central = true,
            .point = scene.centre(),
            .normal = n,
            .up = {0, 0, 1},
            .projector = distance * scene.diagonal() * n};  // scene.centre() + is missing
  }
};
EPURA_PROJECTION(WrongCentre)
