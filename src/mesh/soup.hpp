// SPDX-License-Identifier: Apache-2.0
// The raw content of a file: points, polygons as runs of corner indices, and lines that bound no polygon.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace epura::mesh {

using Points = std::vector<std::array<double, 3>>;

struct Soup {
  Points points;
  std::vector<int> corners;    ///< corner indices of all faces, one face after the other, all in range
  std::vector<int> face_ends;  ///< where each face ends in `corners`
  std::vector<int> face_body;  ///< named group of each face; empty when the file names none
  std::vector<std::string> body_names;
  /// The straight pieces of wires: from point to point, in range. None where `corners_repeat_points`.
  std::vector<std::array<int, 2>> wires;
  int wire_faces = 0;                  ///< faces without corners, which only keep the numbers of the others
  std::string format;                  ///< "obj", "stl", "ply", "off"
  bool single_precision = false;       ///< coordinates are stored in 32 bits
  bool printed = false;                ///< coordinates were written as text, so perhaps rounded to decimals
  bool corners_repeat_points = false;  ///< every face brings its own points (STL)
  std::vector<std::string> notes;

  /// The corners added since the last face are a face.
  void end_face() { face_ends.push_back(static_cast<int>(corners.size())); }

  /// Through these points.
  template <class Numbers>
  void add_wire(const Numbers& numbers) {
    for (std::size_t i = 1; i < numbers.size(); ++i)
      wires.push_back({static_cast<int>(numbers[i - 1]), static_cast<int>(numbers[i])});
  }
};

}  // namespace epura::mesh
