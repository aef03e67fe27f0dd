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

/// A straight piece of a drawn edge on paper.
struct Piece {
  Vec2 from, to;  ///< mm
  bool visible;
  EdgeKind kind;
  int edge;                 ///< index in the list of drawn edges
  std::array<double, 2> s;  ///< page parameters of the ends along the edge
};

/// The piece with the lower rank is drawn.
inline auto rank(const Piece& p) { return std::tuple(!p.visible, p.kind, p.edge, p.s[0]); }

inline double length_of(const Piece& p) { return glm::length(p.to - p.from); }

/// A straight line on paper to measure from.
struct Ruler {
  Vec2 from, along;  ///< `along` has length 1
  double length;     ///< mm

  Ruler(const Vec2& start, const Vec2& end)
      : from(start), along((end - start) / glm::length(end - start)), length(glm::length(end - start)) {}

  /// Returns the position along the line and to the left of it, mm.
  [[nodiscard]] Vec2 local(const Vec2& p) const {
    const Vec2 d = p - from;
    return {glm::dot(d, along), along.x * d.y - along.y * d.x};
  }
};

/// Returns the part of a line, in mm from its start, over which the line a, b lies within `tolerance` of it; {0, 0} if
/// it is shorter than `min`.
std::array<double, 2> covered_part(const Ruler& line, Vec2 a, Vec2 b, double tolerance, double min);

/// Removes from every piece the parts that a piece of higher rank already draws: those within `tolerance` mm of it over
/// at least `min` mm. Remainders shorter than `min` are dropped. Keeps the order; the parts of a divided piece take its
/// place. Throws OutOfTime.
std::vector<Piece> resolve_coincident(std::vector<Piece> pieces, double tolerance, double min,
                                      const Progress& progress = {});

}  // namespace epura::drawing
