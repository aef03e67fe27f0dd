// SPDX-License-Identifier: Apache-2.0
// Debian builds tinygltf without compression: it refuses a file where indices are in no view, as those of primitives
// that Draco compressed, or a buffer has no bytes, as that of views that meshoptimizer compressed, or of no meshes.
#pragma once

#include <string>
#include <string_view>

namespace epura::plugin::gltf {

/// JSON in which compressed primitives have the indices -1, which is none for tinygltf, and the extension has the
/// member "indices" instead, and in which buffers without bytes have one. All else stays as it is written, also where
/// it is no JSON.
std::string set_aside(std::string_view json);

}  // namespace epura::plugin::gltf
