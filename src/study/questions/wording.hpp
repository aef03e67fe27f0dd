// SPDX-License-Identifier: Apache-2.0
// Numbers and places in sentences.
#pragma once

#include <string>

#include "base/text.hpp"
#include "base/vec.hpp"

namespace epura {

inline std::string in_words(double number) { return format_rounded(number, 6); }

inline std::string in_words(const Vec2& p) { return "(" + in_words(p.x) + ", " + in_words(p.y) + ")"; }

inline std::string in_words(const Vec3& p) {
  return "(" + in_words(p.x) + ", " + in_words(p.y) + ", " + in_words(p.z) + ")";
}

}  // namespace epura
