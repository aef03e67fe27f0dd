// SPDX-License-Identifier: Apache-2.0
// Surface texture. ISO 21920-1.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/choices.hpp"

namespace epura::scene {

template <>
struct Words<MaterialRemoval> {
  static constexpr std::array list{"any", "required", "prohibited"};
};

struct SurfaceTexture {
  MaterialRemoval removal = MaterialRemoval::any;
  std::vector<std::string> lines{};  ///< requirements: "Ra 3.2"; none for the bare symbol
  std::string process{};             ///< how the surface is made: "ground"
  bool others = false;               ///< of a general one: symbols on the sheet say otherwise; not in scene files
};

}  // namespace epura::scene
