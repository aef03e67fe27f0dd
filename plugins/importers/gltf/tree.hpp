// SPDX-License-Identifier: Apache-2.0
// Nodes of glTF, from the roots to the leaves.
#pragma once

#include <tiny_gltf.h>

#include <epura/importer_plugin.hpp>
#include <vector>

namespace epura::plugin::gltf {

/// A node, and the index of its parent in the list.
struct Placed {
  std::size_t node;
  std::size_t parent;  ///< no_parent for a root
};
inline constexpr std::size_t no_parent = static_cast<std::size_t>(-1);

/// The nodes of the default scene, or of all scenes if there is no default, or all roots if there is no scene; each
/// after its parent. Throws std::runtime_error if they do not form a tree.
std::vector<Placed> placed_nodes(const tinygltf::Model& model);

/// The transform to the parent.
Transform transform_of(const tinygltf::Model& model, std::size_t node);

}  // namespace epura::plugin::gltf
