// SPDX-License-Identifier: Apache-2.0
// Closes cracks: adjacent open edges whose vertices should be equal but differ in the last bits.
#pragma once

#include "mesh/edge_table.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

struct Mending {
  std::vector<int> representative;  ///< for each vertex the lowest one with which it is merged; empty if none is merged
  int joined = 0;                   ///< vertices that are not their own representative
  double distance = 0;              ///< largest distance to a representative
};

/// Merges ends of open edges that lie within a few roundings of each other, and much closer than the length of their
/// open edges; never two vertices with an edge between them. `corners` are those of the table; `resolution` is the
/// distance between neighbouring values of coordinates, 0 for full numbers.
Mending mend_cracks(const Points& points, std::span<const int> corners, const EdgeTable& table, double resolution);

}  // namespace epura::mesh
