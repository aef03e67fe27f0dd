// SPDX-License-Identifier: Apache-2.0
// Lines that coincide on paper.
#pragma once

#include <compare>
#include <vector>

#include "drawing/ink.hpp"

namespace epura::drawing {

/// A part of a piece that is already drawn by a piece of higher rank, in mm from its beginning.
struct Cover {
  int piece;
  double from, to;

  auto operator<=>(const Cover&) const = default;
};

/// Returns the parts of at least `min` mm that lie within `tolerance` mm of a piece of higher rank, sorted and without
/// duplicates. Where very many pieces lie on one line, parts are merged, and parts that only shorten gaps of less than
/// `min` are left out. No piece may be a point. Throws OutOfTime.
std::vector<Cover> find_covers(const std::vector<Piece>& pieces, double tolerance, double min,
                               const Progress& progress = {}, Order has_higher_rank = outranks);

}  // namespace epura::drawing
