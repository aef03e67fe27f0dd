// SPDX-License-Identifier: Apache-2.0
// The places of a node's mesh that EXT_mesh_gpu_instancing gives.
#pragma once

#include <tiny_gltf.h>

#include <epura/importer_plugin.hpp>
#include <vector>

namespace epura::plugin::gltf {

inline constexpr const char* instancing_extension = "EXT_mesh_gpu_instancing";

/// Whether a node has the extension.
bool has_instances(const tinygltf::Node& node);

/// Transforms to the node, of which each holds one copy of its mesh. Throws std::runtime_error with a sentence.
std::vector<Transform> instances_of(const tinygltf::Model& model, std::size_t node);

}  // namespace epura::plugin::gltf
