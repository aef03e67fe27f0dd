// SPDX-License-Identifier: Apache-2.0
// Formats the parts of an assembly, as text and as JSON.
#pragma once

#include <string>
#include <vector>

#include "importer/assemble.hpp"

namespace epura {

/// Returns lines indented by two spaces per level. Parts under one parent that are equal, including everything below
/// them, share a line: "bolt x 3, 7 faces".
std::vector<std::string> tree_lines(const std::vector<importer::TreePart>& tree);

/// Returns a list of {"name", "bodies", "faces", "parts"}.
std::string tree_json(const std::vector<importer::TreePart>& tree);

}  // namespace epura
