// SPDX-License-Identifier: Apache-2.0
// A glTF or GLB file -> its tables and buffers, by tinygltf. The other files that it may open are determined here.
#pragma once

#include <tiny_gltf.h>

#include <epura/importer_plugin.hpp>
#include <string>
#include <string_view>

namespace epura::plugin::gltf {

/// Buffers in separate files must be in the folder of the file or below it, unless it may leave that: other URIs are
/// refused, and images are not opened. Throws std::runtime_error with a sentence.
tinygltf::Model load(const Source& source, std::string& warning);

/// Whether a file begins like glTF or GLB.
bool is_gltf(std::string_view first_bytes);

}  // namespace epura::plugin::gltf
