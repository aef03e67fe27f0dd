// SPDX-License-Identifier: Apache-2.0
// When two directions are one, for all stages that draw.
#pragma once

namespace epura {

inline constexpr double parallel_sine = 1e-6;  ///< of 0.00006 degrees; but for rounding, directions are parallel
/// Of 0.06 degrees; facets, and generators and lines that files round, do not tell closer directions apart.
inline constexpr double told_apart_sine = 1e-3;

}  // namespace epura
