// SPDX-License-Identifier: Apache-2.0
// Hidden-line removal for a triangle mesh by Open CASCADE's HLRBRep_PolyAlgo.
#pragma once

#include <array>
#include <vector>

#include "patches.hpp"

namespace epura::bench {

using Segment = std::array<Vec2, 2>;

struct Drawn {
  std::vector<Segment> visible, hidden;
};

/// Lines of the mesh seen along -z: outlines, open edges, and edges with a fold of more than `crease_angle` degrees.
Drawn remove_hidden_lines(const TriangleMesh& mesh, double crease_angle);

}  // namespace epura::bench
