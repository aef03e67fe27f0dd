// SPDX-License-Identifier: Apache-2.0
// Numbers to which accessors refer in buffers. All offsets and counts of a file are checked here.
#pragma once

#include <tiny_gltf.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <span>
#include <string>
#include <vector>

namespace epura::plugin::gltf {

/// The corners of a primitive, in the order given by its mode.
struct Corners {
  std::vector<Point> points;
  std::vector<std::uint32_t> numbers;
  double step = 0;  ///< distance between neighbouring values of quantised coordinates; 0: they are not quantised
};

/// These throw std::runtime_error with a sentence that names the accessor or view. Positions have 32 bits, or are
/// integers of 8 or 16 bits according to KHR_mesh_quantization.
std::vector<Point> positions(const tinygltf::Model& model, int accessor);
/// Rotations: x, y, z, w.
std::vector<std::array<double, 4>> quaternions(const tinygltf::Model& model, int accessor);
std::vector<std::uint32_t> indices(const tinygltf::Model& model, int accessor);

/// The distance between neighbouring integers of positions; 0 for floats.
double step_of(const tinygltf::Accessor& positions);

/// The accessor, which has such a type. Its count is not checked.
const tinygltf::Accessor& accessor_at(const tinygltf::Model& model, int accessor, int type);

/// The accessor of positions; `what` is "mesh 2, primitive 1".
int position_of(const tinygltf::Primitive& primitive, const std::string& what);

/// The bytes of a buffer view.
std::span<const unsigned char> bytes_of(const tinygltf::Model& model, int view);

}  // namespace epura::plugin::gltf
