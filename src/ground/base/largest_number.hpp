// SPDX-License-Identifier: Apache-2.0
// The border for numbers from outside.
#pragma once

#include <cmath>

#include "base/vec.hpp"

namespace epura {

/// The largest magnitude of a coordinate, and of any other number that a file or an option states: beyond all that is
/// ever drawn, while its sixth power, as in a square of a volume, is still a number.
inline constexpr double largest_number = 1e50;

/// False for NaN, too.
inline bool is_usable(double number) { return std::abs(number) <= largest_number; }
inline bool is_usable(const Vec3& v) { return is_usable(v.x) && is_usable(v.y) && is_usable(v.z); }

}  // namespace epura
