// SPDX-License-Identifier: Apache-2.0
// Where lines coincide on paper, one of them is drawn, if a style draws any: visible before hidden (ISO 128), then the
// outline of a cut face, then the stronger kind, then the longer line. Nothing in this depends on the order of edges,
// except between lines that are equal in all of it.
#pragma once

#include <array>
#include <vector>

#include "base/progress.hpp"
#include "base/vec.hpp"
#include "edges/edge_kind.hpp"

namespace epura::drawing {

/// A straight piece of a drawn edge on paper.
struct Piece {
  Vec2 from, to;  ///< mm
  bool visible;
  bool drawn;  ///< whether its style leaves ink
  EdgeKind kind;
  int edge;                 ///< index in the list of drawn edges
  std::array<double, 2> s;  ///< page parameters of the ends along the edge
  bool is_step = false;     ///< FacesEdgeOn::has_step
  bool by_facets = false;   ///< only facets hide it that lie behind it as their surface does: facet_doubts.hpp decides
  double line = 0;  ///< length of the straight line of which it is a part over several facets, mm; 0: it is whole
};

/// What is left of pieces, and within which distance of what was removed there is ink, mm.
struct LeftInk {
  std::vector<Piece> pieces;
  double within = 0;
};

/// Whether a piece leads from a point of its edge to another line.
inline bool is_link(const Piece& p) { return p.s[0] == p.s[1]; }

/// Whether the first piece is drawn where both coincide.
bool outranks(const Piece& a, const Piece& b);

/// An order like that of `outranks`.
using Order = bool (*)(const Piece&, const Piece&);

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
    return {glm::dot(d, along), cross(along, d)};
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
