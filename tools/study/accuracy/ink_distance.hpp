// SPDX-License-Identifier: Apache-2.0
// Distances of lines from the ink of a drawing.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::study {

struct InkLine {
  Vec2 from, to;  ///< mm
};

/// The directed Hausdorff distance: the largest distance of a point on `lines` from `ink`, with a relative error of at
/// most a thousandth. 0 without lines; infinite without ink.
double farthest_from_ink(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink);

}  // namespace epura::study
