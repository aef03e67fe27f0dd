// SPDX-License-Identifier: Apache-2.0
// Which extensions of glTF may be in a file.
#pragma once

#include <tiny_gltf.h>

namespace epura::plugin::gltf {

/// Throws std::runtime_error where a file needs one that changes what is drawn and is not read.
void expect_extensions(const tinygltf::Model& model);

}  // namespace epura::plugin::gltf
