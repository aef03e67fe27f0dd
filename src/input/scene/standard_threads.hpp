// SPDX-License-Identifier: Apache-2.0
// The metric screw threads of ISO 261.
#pragma once

#include <vector>

#include "scene/threads.hpp"

namespace epura::scene {

/// What a cylinder with a thread may measure, in pitches from the major diameter: a core hole is drilled a little
/// smaller or larger than the minor diameter, and a shaft turned a little smaller than the major one.
inline constexpr double smallest_hole = 1.3, largest_hole = 0.5, smallest_shaft = 0.35;
inline constexpr double largest_shaft = 1.02;  ///< relative

/// Whether a hole or shaft with this diameter may have a thread.
bool suits(const Thread& thread, double diameter, bool internal);

/// Returns the threads of all pitches with a nominal diameter in a range, by diameter, the coarse one first.
std::vector<Thread> threads_between(double from, double to);

}  // namespace epura::scene
