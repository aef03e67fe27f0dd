// SPDX-License-Identifier: Apache-2.0
// Numbers that accessors find in buffers. All that a file says about places and counts is checked here.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <span>
#include <vector>

namespace epura::plugin::gltf {

/// These throw std::runtime_error with a sentence that names the accessor or view. Positions are of 32 bits, or
/// integers of 8 and 16 bits after KHR_mesh_quantization.
std::vector<Point> positions(const tinygltf::Model& model, int accessor);
std::vector<std::uint32_t> indices(const tinygltf::Model& model, int accessor);

/// Of a view.
std::span<const unsigned char> bytes_of(const tinygltf::Model& model, int view);

}  // namespace epura::plugin::gltf
