// SPDX-License-Identifier: Apache-2.0
// Detects STL files and their kind.
#pragma once

#include <string_view>

namespace epura::mesh {

enum class StlKind { text, binary, neither };

/// Binary files are recognised by their size alone, since their headers may begin with "solid" as well.
StlKind stl_kind(std::string_view bytes);

}  // namespace epura::mesh
