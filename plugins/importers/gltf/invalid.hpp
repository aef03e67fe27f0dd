// SPDX-License-Identifier: Apache-2.0
// What tinygltf says of a file, in words for the user.
#pragma once

#include <string>

namespace epura::plugin::gltf {

/// A sentence without a subject, for "the file ..." or "is not a valid glTF file: it ...".
std::string sentence_for(const std::string& error);

}  // namespace epura::plugin::gltf
