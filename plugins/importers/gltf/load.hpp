// SPDX-License-Identifier: Apache-2.0
// A glTF or GLB file -> its tables and buffers, by tinygltf. What a file may open beside itself is decided here.
#pragma once

#include <tiny_gltf.h>

#include <string>
#include <string_view>

namespace epura::plugin::gltf {

/// Buffers of their own lie in the folder of the file or below it: any other URI is refused, and no image is opened.
/// Throws std::runtime_error with a sentence.
tinygltf::Model load(const std::string& path, std::string& warning);

/// Whether a file begins like one.
bool is_gltf(std::string_view first_bytes);

}  // namespace epura::plugin::gltf
