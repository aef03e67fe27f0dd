// SPDX-License-Identifier: Apache-2.0
// Numbers to which accessors refer in buffers. All offsets and counts of a file are checked here.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <span>
#include <vector>

namespace epura::plugin::gltf {

/// These throw std::runtime_error with a sentence that names the accessor or view. Positions have 32 bits, or are
/// integers of 8 or 16 bits according to KHR_mesh_quantization.
std::vector<Point> positions(const tinygltf::Model& model, int accessor);
std::vector<std::uint32_t> indices(const tinygltf::Model& model, int accessor);

/// The bytes of a buffer view.
std::span<const unsigned char> bytes_of(const tinygltf::Model& model, int view);

}  // namespace epura::plugin::gltf
