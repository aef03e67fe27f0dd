// SPDX-License-Identifier: Apache-2.0
// The keyword that identifies OFF files.
#pragma once

#include <string_view>

namespace epura::mesh {

/// Returns the keyword at the beginning of the first word of a file, [ST][C][N][4][n]OFF; empty if there is none.
/// Numbers may follow immediately: "OFF8".
std::string_view off_keyword(std::string_view word);

}  // namespace epura::mesh
