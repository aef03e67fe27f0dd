// SPDX-License-Identifier: Apache-2.0
// Takes one parameter of each type and answers with what it was given, so that a test sees what arrived.
#include <epura/projection_plugin.hpp>

using namespace epura::plugin;

struct EveryType {
  static constexpr auto name = "every-type";
  static constexpr auto family = "test";
  static constexpr auto summary = "a parameter of each type";
  static constexpr const char* reference = nullptr;
  static constexpr std::array parameters{
      vector<2>("pair", "1", "front and back", {1, -1}), choice("word", "the scale", "none|single|double", 1),
      vector<3>("point", "model units", "the point"),    number("ratio", "1", "the slant", 0.5, -3, 3),
      choice("central", "the projectors", "no|yes", 0),  vector<4>("window", "1", "the window", {0, 0, 0, 0}),
  };

  static View project(const Scene& scene, std::array<double, 2> pair, int word, const Vec3& point, double ratio,
                      bool central, const std::array<double, 4>& window) {
    return {.central = central,
            .point = std::isnan(point.x) ? scene.most : point,
            .normal = {0, -1, 0},
            .up = {0, 0, 1},
            .projector = {ratio, -1e3, 0},
            .scale = double(word),
            .window = window,
            .front = pair[0],
            .back = pair[1]};
  }
};
EPURA_PROJECTION(EveryType)
