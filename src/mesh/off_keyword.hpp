// SPDX-License-Identifier: Apache-2.0
// The keyword that identifies OFF files.
#pragma once

#include <string_view>

namespace epura::mesh {

/// The keyword that the first word of a file begins with, [ST][C][N][4][n]OFF; empty if there is none. Numbers may
/// follow immediately: "OFF8".
std::string_view off_keyword(std::string_view word);

}  // namespace epura::mesh
