// SPDX-License-Identifier: Apache-2.0
// The visible part of a slice: at each position of the line, the piece nearest to the viewer.
#pragma once

#include <vector>

#include "verify/slice.hpp"

namespace epura::verify {

/// A stretch of the line over which one piece is in front.
struct SeenPart {
  double from, to;
  int piece;  ///< of the slice
};

/// Ascending; where nothing is seen there is no part. Found by merging halves (Hershberger, Finding the upper envelope
/// of n line segments in O(n log n) time, IPL 1989, without its refinement). Where two are equal the first one wins.
std::vector<SeenPart> upper_envelope(const Slice& slice);

}  // namespace epura::verify
