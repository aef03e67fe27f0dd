// SPDX-License-Identifier: Apache-2.0
// The parts of an assembly, for people and as JSON.
#pragma once

#include <string>
#include <vector>

#include "importer/assemble.hpp"

namespace epura {

/// Two spaces deeper a level; parts that are equal with all that is in them, under one parent, on one line:
/// "bolt x 3, 7 faces".
std::vector<std::string> tree_lines(const std::vector<importer::TreePart>& tree);

/// A list of {"name", "bodies", "faces", "parts"}.
std::string tree_json(const std::vector<importer::TreePart>& tree);

}  // namespace epura
