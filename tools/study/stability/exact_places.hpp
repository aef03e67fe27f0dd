// SPDX-License-Identifier: Apache-2.0
// Positions on the page in rational numbers, and the error of a view.
#pragma once

#include "laboratory/lab.hpp"
#include "study/stability/measured.hpp"

namespace epura::stability {

using namespace laboratory;

/// The largest distance on the page between a corner of the world in `result` and the image of its coordinates by
/// (3.10) or (3.20) in rationals, both relative to the first corner, as a fraction of the drawing. Corners behind the
/// viewer do not count.
Quantity places(const Result& result, double allowed = guaranteed_part);

}  // namespace epura::stability
