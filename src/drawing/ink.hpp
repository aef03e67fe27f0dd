// Where several lines fall on one line of the paper, one of them is drawn: visible before hidden (ISO 128), then the
// stronger kind, then the earlier edge.
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "edges/edge_kind.hpp"

namespace epura {

/// A straight piece of a drawn edge on the paper.
struct Piece {
  Vec2 from, to;  ///< mm
  bool visible;
  EdgeKind kind;
  int edge;                 ///< in the list of drawn edges
  std::array<double, 2> s;  ///< page parameters of the ends along it
};

/// Removes from every piece what a piece of higher rank draws already: what lies within `tolerance` mm of it over at
/// least `least` mm. Remainders shorter than `least` are dropped. Keeps the order; what is cut stays in place.
std::vector<Piece> resolve_coincident(std::vector<Piece> pieces, double tolerance, double least);

}  // namespace epura
