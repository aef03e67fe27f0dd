// SPDX-License-Identifier: Apache-2.0
// Two projections whose functions throw: the C++ face turns that into sentences.
#include <epura/projection_plugin.hpp>

using namespace epura::plugin;

template <int which>
struct Throws {
  static constexpr auto name = which == 0 ? "throws-error" : "throws-number";
  static constexpr auto family = "test";
  static constexpr auto summary = "never answers";
  static constexpr const char* reference = nullptr;
  static constexpr auto parameters = no_parameters;

  static View project(const Scene&) {
    if (which == 0) throw std::invalid_argument("the moon is not full");
    throw 1;
  }
};
EPURA_PROJECTIONS(Throws<0>, Throws<1>)
