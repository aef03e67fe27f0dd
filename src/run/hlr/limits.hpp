// SPDX-License-Identifier: Apache-2.0
// Every number that decides something in this folder.
#pragma once

#include <cstddef>

namespace epura::hlr {

/// Longest side of a drawing whose scale is not given, mm of paper.
inline constexpr double usual_side_mm = 1000;
/// Points that division makes of each one of a shape, on average: then facets are some 1000 times nearer to the
/// surface. More are a sign of a function that is none, or of a tolerance below rounding.
inline constexpr std::size_t most_points_for_one = 1000;

/// By how much squares of the axes of a circle may differ, of one of them: rounding.
inline constexpr double equal_axes = 1e-9;

}  // namespace epura::hlr
