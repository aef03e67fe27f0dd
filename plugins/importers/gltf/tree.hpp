// SPDX-License-Identifier: Apache-2.0
// Nodes of glTF, from the roots to the leaves.
#pragma once

#include <tiny_gltf.h>

#include <epura/importer_plugin.hpp>
#include <string>
#include <vector>

namespace epura::plugin::gltf {

/// A node, and the index of its parent in the list.
struct Placed {
  std::size_t node;
  std::size_t parent;  ///< no_parent for a root
};
inline constexpr std::size_t no_parent = static_cast<std::size_t>(-1);

/// Nodes to draw, and a sentence about those that are not drawn; empty if there are none.
struct Scene {
  std::vector<Placed> nodes;
  std::string left_out{};
};

/// The nodes of the default scene, or of the first one if there is no default, or all roots if there is no scene; each
/// after its parent. Hidden ones (KHR_node_visibility) are left out, with those below them. Throws std::runtime_error
/// if the nodes do not form a tree.
Scene scene_of(const tinygltf::Model& model);

/// Numbers of a node; each may be empty.
struct Motion {
  std::vector<double> translation, rotation, scale;
};

/// The transform that scales first and moves last; `what` has it. Throws std::runtime_error with a sentence.
Transform composed(const Motion& motion, const std::string& what);

/// The transform to the parent.
Transform transform_of(const tinygltf::Model& model, std::size_t node);

}  // namespace epura::plugin::gltf
