// SPDX-License-Identifier: Apache-2.0
// Numbers in files that are beyond all that can be drawn: Open CASCADE computes with them for minutes and gigabytes, or
// draws something else without a word.
#pragma once

#include <string_view>

namespace occt {

/// The largest magnitude of a coordinate, of a radius, or of a bound of a curve.
inline constexpr double largest_number = 1e50;

/// Throw if a number of the file is larger, and is not the one by which Open CASCADE means that a curve has no end;
/// they name the entity of STEP, or the line.
void expect_drawable_step(std::string_view text);
void expect_drawable_iges(std::string_view text);
void expect_drawable_brep(std::string_view text);

}  // namespace occt
