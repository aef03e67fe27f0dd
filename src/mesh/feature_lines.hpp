// Creases and boundaries of a mesh, end to end as far as they run on.
#pragma once

#include <vector>

#include "mesh/mesh.hpp"

namespace epura {

struct FeatureLine {
  std::vector<int> vertices;  ///< of the file; at least two. Of a closed line the first one is not repeated.
  bool closed;
};

/// Lines along edges with one triangle, with three or more, and with two that are folded by `crease_angle` degrees or
/// more. Each edge is in one line. Where several meet in a vertex, those that run on most straightly are joined;
/// lines end where they would turn by more than `most_turn` radians.
std::vector<FeatureLine> find_feature_lines(const Mesh& mesh, double crease_angle, double most_turn);

}  // namespace epura
