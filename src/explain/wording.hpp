// SPDX-License-Identifier: Apache-2.0
// Numbers and places in sentences.
#pragma once

#include <string>

#include "base/text.hpp"
#include "base/vec.hpp"

namespace epura::explain {

inline std::string format_value(double number) { return format_rounded(number, 6); }

inline std::string format_value(const Vec2& p) { return "(" + format_value(p.x) + ", " + format_value(p.y) + ")"; }

inline std::string format_value(const Vec3& p) {
  return "(" + format_value(p.x) + ", " + format_value(p.y) + ", " + format_value(p.z) + ")";
}

}  // namespace epura::explain
