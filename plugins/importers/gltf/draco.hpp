// SPDX-License-Identifier: Apache-2.0
// Primitives after KHR_draco_mesh_compression.
#pragma once

#include <string>

#include "accessors.hpp"

namespace epura::plugin::gltf {

inline constexpr const char* draco_extension = "KHR_draco_mesh_compression";

/// Whether this was built with the library that decompresses.
bool reads_draco();

inline bool is_compressed(const tinygltf::Primitive& primitive) {
  return reads_draco() && primitive.extensions.count(draco_extension) != 0;
}

/// `what` is "mesh 2, primitive 1". Throws std::runtime_error with a sentence, also where the data hold other numbers
/// of points and corners than the accessors say.
Corners decompressed(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const std::string& what);

}  // namespace epura::plugin::gltf
