// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

namespace epura {

inline constexpr double degree = std::numbers::pi / 180;   ///< in radians
inline constexpr double degrees = 180 / std::numbers::pi;  ///< of one radian
inline constexpr double full_turn = 2 * std::numbers::pi;  ///< in radians

inline constexpr double parallel_sine = 1e-6;  ///< of 0.00006 degrees; but for rounding, directions are parallel
/// Of 0.06 degrees; facets, and generators and lines that files round, do not tell closer directions apart.
inline constexpr double told_apart_sine = 1e-3;

}  // namespace epura
