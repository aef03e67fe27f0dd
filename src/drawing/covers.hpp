// SPDX-License-Identifier: Apache-2.0
// Lines that coincide on paper.
#pragma once

#include <compare>
#include <vector>

#include "drawing/ink.hpp"

namespace epura::drawing {

/// A part of a piece that a piece of higher rank draws already, in mm from its beginning.
struct Cover {
  int piece;
  double from, to;

  auto operator<=>(const Cover&) const = default;
};

/// Parts of at least `min` mm that lie within `tolerance` mm of a piece of higher rank, sorted, each once. Where very
/// many pieces lie on one line, parts are joined, and parts that only shorten gaps of less than `min` are left out.
/// No piece is a point. Throws OutOfTime.
std::vector<Cover> find_covers(const std::vector<Piece>& pieces, double tolerance, double min,
                               const Progress& progress = {});

}  // namespace epura::drawing
