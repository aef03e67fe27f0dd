// SPDX-License-Identifier: Apache-2.0
// Closes cracks: adjacent open edges whose vertices should be equal but differ in the last bits.
#pragma once

#include "base/vec.hpp"
#include "mesh/edge_table.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

struct Mending {
  std::vector<int> representative;  ///< for each vertex the lowest one with which it is merged; empty if none is merged
  int joined = 0;                   ///< vertices that are not their own representative
  double distance = 0;              ///< largest distance to a representative
};

/// Of the length of an open edge: cracks are much narrower than they are long, and genuine small edges survive.
inline constexpr double widest_crack = 0.25;

/// How near ends of open edges are that belong together.
struct CrackLimits {
  double width;  ///< distance over which roundings part them
  Vec3 largest;  ///< coordinates of the model
  /// Of the largest coordinate of an edge, but no more than the largest one along an axis: nothing but rounding made
  /// edges that are not longer along any axis.
  double shortest_part;
};

/// For triangles with these corners. `resolution` is the distance between neighbouring values of coordinates, 0 for
/// full numbers.
CrackLimits limits_of_cracks(const Points& points, std::span<const int> corners, double resolution);

/// Merges ends of open edges that lie within the width of a crack of each other, and much closer than the length of
/// their open edges; never two vertices with an edge between them, unless rounding made that.
Mending mend_cracks(const Points& points, const EdgeTable& table, const CrackLimits& limits);

}  // namespace epura::mesh
