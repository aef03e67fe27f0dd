// SPDX-License-Identifier: Apache-2.0
// Numbers that accessors find in buffers. All that a file says about places and counts is checked here.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <span>
#include <string>
#include <vector>

namespace epura::plugin::gltf {

/// The corners of a primitive, as its mode strings them together.
struct Corners {
  std::vector<Point> points;
  std::vector<std::uint32_t> numbers;
};

/// These throw std::runtime_error with a sentence that names the accessor or view. Positions are of 32 bits, or
/// integers of 8 and 16 bits after KHR_mesh_quantization.
std::vector<Point> positions(const tinygltf::Model& model, int accessor);
std::vector<std::uint32_t> indices(const tinygltf::Model& model, int accessor);

/// Of such a type. Its count may be anything.
const tinygltf::Accessor& accessor_at(const tinygltf::Model& model, int accessor, int type);

/// The accessor of positions; `what` is "mesh 2, primitive 1".
int position_of(const tinygltf::Primitive& primitive, const std::string& what);

/// Of a view.
std::span<const unsigned char> bytes_of(const tinygltf::Model& model, int view);

}  // namespace epura::plugin::gltf
