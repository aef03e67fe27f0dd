// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace epura {

inline constexpr double degree = std::numbers::pi / 180;   ///< in radians
inline constexpr double degrees = 180 / std::numbers::pi;  ///< of one radian
inline constexpr double full_turn = 2 * std::numbers::pi;  ///< in radians

}  // namespace epura
