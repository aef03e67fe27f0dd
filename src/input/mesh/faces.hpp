// SPDX-License-Identifier: Apache-2.0
// Faces as rings of vertex numbers; drops invalid ones.
#pragma once

#include <span>
#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

struct Faces {
  std::vector<int> corners;  ///< all rings, one after the other
  std::vector<int> ends;     ///< end of each ring
  std::vector<int> number;   ///< of each face, in the file

  [[nodiscard]] std::size_t size() const { return ends.size(); }
  [[nodiscard]] int begin_of(std::size_t face) const { return face == 0 ? 0 : ends[face - 1]; }
  [[nodiscard]] std::span<const int> ring(std::size_t face) const {
    return {corners.data() + begin_of(face), static_cast<std::size_t>(ends[face] - begin_of(face))};
  }
};

// Each of these functions returns the number of dropped faces. The order of the others is preserved.

/// Also removes consecutive repetitions of a vertex from rings.
int drop_faces_without_three_corners(Faces& faces);

int drop_faces_with_non_finite_corners(Faces& faces, const Points& points);

/// Two faces of the file with the same vertices, by their numbers.
struct TwinFaces {
  int first, second;
};

/// Of faces with the same vertices in the same cyclic order or its reverse, keeps the first. A face that is there
/// twice, unlike others with which it is connected, may belong to two bodies: both are kept and appended to `twins`.
/// What is there several times as a whole counts once.
int drop_duplicate_faces(Faces& faces, int vertex_count, std::vector<TwinFaces>& twins);

/// Drops the faces with these numbers, which are in ascending order.
void drop_numbered_faces(Faces& faces, const std::vector<int>& numbers);

}  // namespace epura::mesh
