// SPDX-License-Identifier: Apache-2.0
// Faces as rings of vertex numbers, and which of them are valid.
#pragma once

#include <span>
#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

struct Faces {
  std::vector<int> corners;  ///< all rings, one after the other
  std::vector<int> ends;     ///< where each ends
  std::vector<int> number;   ///< of each face in the file

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] int begin_of(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
  [[nodiscard]] std::span<const int> ring(std::size_t face) const {
    return {corners.data() + begin_of(face), static_cast<std::size_t>(ends[face] - begin_of(face))};
  }
};

// Each of these returns how many faces it dropped. The order of the rest stays.

/// Also shortens rings that name one vertex twice in succession.
int drop_faces_without_three_corners(Faces& faces);

int drop_faces_with_non_finite_corners(Faces& faces, const Points& points);

/// Keeps the first of faces that go through the same vertices in the same order, whatever their start and direction.
int drop_duplicate_faces(Faces& faces, int vertex_count);

}  // namespace epura::mesh
