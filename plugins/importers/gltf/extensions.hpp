// SPDX-License-Identifier: Apache-2.0
// The extensions of glTF that a file may use.
#pragma once

#include <tiny_gltf.h>

namespace epura::plugin::gltf {

/// Throws std::runtime_error if a file requires an unsupported extension that changes the drawing.
void expect_extensions(const tinygltf::Model& model);

}  // namespace epura::plugin::gltf
