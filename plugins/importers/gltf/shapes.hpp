// SPDX-License-Identifier: Apache-2.0
// Meshes of glTF as shapes.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <string>

namespace epura::plugin::gltf {

/// What is not drawn, or not as the file may show it.
struct LeftOut {
  std::size_t points = 0, morphs = 0;

  /// A sentence; empty where nothing was left out.
  [[nodiscard]] std::string sentence() const;
};

/// Hands over a mesh; its number as a shape, EPURA_NONE where it has neither triangles nor lines.
std::uint32_t add_shape(const tinygltf::Model& model, std::size_t mesh, Sink& sink, LeftOut& left_out);

}  // namespace epura::plugin::gltf
