// SPDX-License-Identifier: Apache-2.0
// For builds without meshoptimizer.
#include "meshopt.hpp"

namespace epura::plugin::gltf {

bool reads_meshopt() { return false; }

void decompress_views(tinygltf::Model&) {}

}  // namespace epura::plugin::gltf
