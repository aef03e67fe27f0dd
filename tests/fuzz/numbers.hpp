// SPDX-License-Identifier: Apache-2.0
// Structured inputs from the bytes of a fuzzer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "base/vec.hpp"

namespace epura::fuzz {

/// Numbers from bytes; zeros after their end.
class Numbers {
 public:
  explicit Numbers(const std::string& bytes) : bytes_(bytes) {}

  [[nodiscard]] bool at_end() const { return next_ >= bytes_.size(); }
  /// From 0 to `count` - 1.
  int below(int count) { return (at_end() ? 0 : static_cast<unsigned char>(bytes_[next_++])) % count; }
  /// A whole number from -`most` to `most`.
  double whole(int most) { return below(2 * most + 1) - most; }
  Vec3 vector(int most) {
    const double x = whole(most), y = whole(most), z = whole(most);
    return {x, y, z};
  }
  /// Up to `most` characters.
  std::string text(int most) {
    const auto wanted = static_cast<std::size_t>(below(most + 1));
    std::string read = bytes_.substr(std::min(next_, bytes_.size()), wanted);
    next_ += read.size();
    return read;
  }
  [[nodiscard]] std::string rest() const { return bytes_.substr(std::min(next_, bytes_.size())); }

 private:
  const std::string& bytes_;
  std::size_t next_ = 0;
};

}  // namespace epura::fuzz
