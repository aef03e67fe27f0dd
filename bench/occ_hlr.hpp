// SPDX-License-Identifier: Apache-2.0
// A triangle mesh through Open CASCADE's HLRBRep_PolyAlgo.
#pragma once

#include <array>
#include <vector>

#include "patches.hpp"

namespace epura::bench {

using Segment = std::array<Vec2, 2>;

struct Drawn {
  std::vector<Segment> visible, hidden;
};

/// Lines of the mesh seen along -z: outlines, open edges, and edges that fold by more than `crease_angle` degrees.
Drawn remove_hidden_lines(const TriangleMesh& mesh, double crease_angle);

}  // namespace epura::bench
