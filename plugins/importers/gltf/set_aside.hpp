// SPDX-License-Identifier: Apache-2.0
// Debian builds tinygltf without Draco: it refuses a file where indices are in no view, as those of compressed
// primitives.
#pragma once

#include <string>
#include <string_view>

namespace epura::plugin::gltf {

/// JSON in which compressed primitives have the indices -1, which is none for tinygltf, and the extension has the
/// member "indices" instead. All else stays as it is written, also where it is no JSON.
std::string set_indices_aside(std::string_view json);

}  // namespace epura::plugin::gltf
