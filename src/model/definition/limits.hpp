// SPDX-License-Identifier: Apache-2.0
// What the accountant takes for the same, and for certain.
#pragma once

#include <cstddef>

namespace epura::definition {

inline constexpr double drawn_parallel = 1e-4;  ///< sine: 0.006 degrees, which no drawing shows and no tolerance means
inline constexpr double drawn_in_line = 2e-5;   ///< relative to the size of the part: one line on paper
inline constexpr double same_size = 1e-4;       ///< relative, of two radii

// Ranks. Singular values are relative to the largest one of rows of length 1, lengths to the size of the part. Vertices
// in 32-bit floats are off by some 1e-7; thirty lengths in a chain have values down to 1e-3.
inline constexpr double surely_zero = 1e-6;         ///< below: nothing holds this combination of unknowns
inline constexpr double surely_not_zero = 1e-4;     ///< above: something holds it; between the two, nobody can tell
inline constexpr std::size_t most_in_doubt = 3000;  ///< unknowns whose singular values are all found: half a minute
inline constexpr double rounding = 1e-11;           ///< factors of rows below are sums that cancel

// Of the method of Levenberg and Marquardt (rebuild.hpp), relative to rows of length 1.
inline constexpr double least_damping = 1e-4;  ///< less is none
inline constexpr double damping_step = 10;     ///< from step to step

inline constexpr double good_base = 0.1;     ///< independence, of what the datum faces hold of the part
inline constexpr double seen_at_all = 1e-3;  ///< the same: motions that show less leave the part as it is
inline constexpr double moves = 1e-6;        ///< relative to the largest change in a motion

}  // namespace epura::definition
