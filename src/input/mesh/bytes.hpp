// SPDX-License-Identifier: Apache-2.0
// Reads numbers in binary files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string_view>

namespace epura::mesh {

/// Returns the number at `from`, which need not be aligned.
template <class Number>
Number load(const char* from, std::endian order) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, bytes.size());
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

/// Returns the keyword at the beginning of the first word of a file, [ST][C][N][4][n]OFF; empty if there is none.
/// Numbers may follow immediately: "OFF8".
std::string_view off_keyword(std::string_view word);

enum class StlKind { text, binary, neither };

/// Binary files are recognised by their size alone, since their headers may begin with "solid" as well.
StlKind stl_kind(std::string_view bytes);

}  // namespace epura::mesh
