// SPDX-License-Identifier: Apache-2.0
// Places on the page in rational numbers, and how far a view is from them.
#pragma once

#include "laboratory/lab.hpp"
#include "study/stability/measured.hpp"

namespace epura::stability {

using namespace laboratory;

/// The largest distance between a corner of the world as `result` has it on the page and the image of its coordinates
/// by (3.10) or (3.20) in rationals, both relative to the first corner, in parts of the drawing. Corners behind the
/// viewer do not count.
Quantity places(const Result& result, double allowed = guaranteed_part);

}  // namespace epura::stability
