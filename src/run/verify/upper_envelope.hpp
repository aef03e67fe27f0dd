// SPDX-License-Identifier: Apache-2.0
// The visible part of a slice: the piece nearest to the viewer at each position of the line.
#pragma once

#include <vector>

#include "verify/slice.hpp"

namespace epura::verify {

/// An interval of the line over which one piece is in front.
struct SeenPart {
  double from, to;
  int piece;  ///< of the slice
};

/// Returns the parts in ascending order; where nothing is seen, there is none. Merges halves (Hershberger, Finding the
/// upper envelope of n line segments in O(n log n) time, IPL 1989, without its refinement). Of two equal pieces, the
/// first wins.
std::vector<SeenPart> upper_envelope(const Slice& slice);

}  // namespace epura::verify
