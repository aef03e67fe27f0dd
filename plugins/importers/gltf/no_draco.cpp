// SPDX-License-Identifier: Apache-2.0
// In place of draco.cpp where its library is not installed.
#include "draco.hpp"
#include "refuse.hpp"

namespace epura::plugin::gltf {

bool reads_draco() { return false; }

Corners decompressed(const tinygltf::Model&, const tinygltf::Primitive&, const std::string& what) {
  refuse_if(true, what + " is compressed by Draco, which is not read");
  return {};
}

}  // namespace epura::plugin::gltf
