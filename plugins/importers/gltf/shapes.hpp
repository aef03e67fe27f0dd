// SPDX-License-Identifier: Apache-2.0
// Meshes of glTF as shapes.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <epura/importer_plugin.hpp>
#include <string>

namespace epura::plugin::gltf {

/// Items that are not drawn, or may be drawn differently from the file.
struct LeftOut {
  std::size_t morphs = 0;

  /// A sentence; empty if nothing was omitted.
  [[nodiscard]] std::string sentence() const;
};

/// A mesh, and what it is called.
struct NamedMesh {
  std::size_t number;
  std::string name;
};

/// Passes a mesh to the sink. Returns its number as a shape, or EPURA_NONE if it has nothing to draw.
std::uint32_t add_shape(const tinygltf::Model& model, const NamedMesh& mesh, Sink& sink, LeftOut& left_out);

}  // namespace epura::plugin::gltf
