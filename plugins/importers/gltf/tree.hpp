// SPDX-License-Identifier: Apache-2.0
// Nodes of glTF, from the roots to the leaves.
#pragma once

#include <tiny_gltf.h>

#include <epura/importer_plugin.hpp>
#include <vector>

namespace epura::plugin::gltf {

/// A node, and its parent's place in the list.
struct Placed {
  std::size_t node;
  std::size_t parent;  ///< no_parent: it is a root
};
inline constexpr std::size_t no_parent = static_cast<std::size_t>(-1);

/// Those of the default scene, of every scene where there is no such, or of all roots where there is no scene; each
/// behind its parent. Throws std::runtime_error where they are no tree.
std::vector<Placed> placed_nodes(const tinygltf::Model& model);

/// To the parent.
Transform transform_of(const tinygltf::Model& model, std::size_t node);

}  // namespace epura::plugin::gltf
