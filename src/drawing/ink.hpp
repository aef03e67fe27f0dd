// SPDX-License-Identifier: Apache-2.0
// Where lines coincide on paper, one of them is drawn: visible before hidden (ISO 128), then the stronger kind, then
// the earlier edge.
#pragma once

#include <array>
#include <tuple>
#include <vector>

#include "base/progress.hpp"
#include "base/vec.hpp"
#include "edges/edge_kind.hpp"

namespace epura::drawing {

/// A straight piece of a drawn edge on the paper.
struct Piece {
  Vec2 from, to;  ///< mm
  bool visible;
  EdgeKind kind;
  int edge;                 ///< in the list of drawn edges
  std::array<double, 2> s;  ///< page parameters of the ends along it
};

/// The lower one is drawn.
inline auto rank(const Piece& p) { return std::tuple(!p.visible, p.kind, p.edge, p.s[0]); }

inline double length_of(const Piece& p) { return glm::length(p.to - p.from); }

/// A straight line of the paper to measure from.
struct Ruler {
  Vec2 from, along;  ///< `along` has length 1
  double length;     ///< mm

  Ruler(const Vec2& start, const Vec2& end)
      : from(start), along((end - start) / glm::length(end - start)), length(glm::length(end - start)) {}

  /// mm along the line and to the left of it.
  [[nodiscard]] Vec2 local(const Vec2& p) const {
    const Vec2 d = p - from;
    return {glm::dot(d, along), along.x * d.y - along.y * d.x};
  }
};

/// The part of a line, in mm from its start, over which the line a, b lies within `tolerance` of it; {0, 0} where that
/// is less than `min`.
std::array<double, 2> covered_part(const Ruler& line, Vec2 a, Vec2 b, double tolerance, double min);

/// Removes from every piece what a piece of higher rank draws already: what lies within `tolerance` mm of it over at
/// least `min` mm. Remainders shorter than `min` are dropped. Keeps the order; what is cut stays in place. Throws
/// OutOfTime.
std::vector<Piece> resolve_coincident(std::vector<Piece> pieces, double tolerance, double min,
                                      const Progress& progress = {});

}  // namespace epura::drawing
