// SPDX-License-Identifier: Apache-2.0
// Meshes of glTF as shapes.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <string>

namespace epura::plugin::gltf {

/// What has no faces, or no such as it is told.
struct LeftOut {
  std::size_t lines = 0, points = 0, morphs = 0;

  /// A sentence; empty where nothing was left out.
  [[nodiscard]] std::string sentence() const;
};

/// Hands over a mesh; its number as a shape, EPURA_NONE where it has no triangles.
std::uint32_t add_shape(const tinygltf::Model& model, std::size_t mesh, Sink& sink, LeftOut& left_out);

}  // namespace epura::plugin::gltf
