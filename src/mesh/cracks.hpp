// SPDX-License-Identifier: Apache-2.0
// Cracks: adjacent open edges whose corners should be equal but differ in the last bits.
#pragma once

#include "mesh/edge_table.hpp"
#include "mesh/soup.hpp"

namespace epura::mesh {

struct Mending {
  std::vector<int> representative;  ///< for each vertex the lowest one it is joined with; empty when none is joined
  int joined = 0;                   ///< vertices that are not their own representative
  double distance = 0;              ///< largest distance to a representative
};

/// Joins ends of open edges that lie within a few roundings of each other, and much closer than their open edges are
/// long; never two vertices with an edge between them. `corners` are those of the table; `precision` is the distance
/// from 1 to the next number that the file can hold.
Mending mend_cracks(const Points& points, std::span<const int> corners, const EdgeTable& table, double precision);

}  // namespace epura::mesh
