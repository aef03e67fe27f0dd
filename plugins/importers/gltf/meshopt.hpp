// SPDX-License-Identifier: Apache-2.0
// Buffer views compressed by meshoptimizer (EXT_meshopt_compression).
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <string_view>

namespace epura::plugin::gltf {

inline constexpr const char* meshopt_extension = "EXT_meshopt_compression";

/// Whether this importer was built with meshoptimizer.
bool reads_meshopt();

/// What undoes the compression, for a sentence.
inline constexpr const char* undoing_meshopt = "'gltfpack -i IN.glb -o OUT.glb -noq' undoes it";

/// Puts uncompressed bytes in the place of compressed views. Throws std::runtime_error with a sentence.
void decompress_views(tinygltf::Model& model);

}  // namespace epura::plugin::gltf
