// SPDX-License-Identifier: Apache-2.0
// How far lines lie from the ink of a drawing.
#pragma once

#include <vector>

#include "base/vec.hpp"

namespace epura::study {

struct InkLine {
  Vec2 from, to;  ///< mm
};

/// The directed Hausdorff distance: the farthest that a place of `lines` lies from `ink`, within a thousandth part.
/// 0 without lines; infinite without ink.
double farthest_from_ink(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink);

}  // namespace epura::study
