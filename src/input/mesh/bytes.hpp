// SPDX-License-Identifier: Apache-2.0
// Reads numbers in binary files.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace epura::mesh {

/// Returns the number at `from`, which need not be aligned.
template <class Number>
Number load(const char* from, std::endian order) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), from, bytes.size());
  if (order != std::endian::native) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<Number>(bytes);
}

}  // namespace epura::mesh
