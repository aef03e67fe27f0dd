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

/// The distance within which this share of the length of `lines` lies, piece by piece of 0.5 mm.
double distance_of_share(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink, double share);

/// The length of what is farther from the ink than `most`, piece by piece of 0.5 mm.
double length_beyond(const std::vector<InkLine>& lines, const std::vector<InkLine>& ink, double most);

}  // namespace epura::study
