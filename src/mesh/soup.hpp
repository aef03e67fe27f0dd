// SPDX-License-Identifier: Apache-2.0
// The raw content of a file: points, and polygons as runs of corner indices.
#pragma once

#include <array>
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
  std::string format;                  ///< "obj", "stl", "ply", "off"
  bool single_precision = false;       ///< coordinates are stored in 32 bits
  bool printed = false;                ///< coordinates were written as text, so perhaps rounded to decimals
  bool corners_repeat_points = false;  ///< every face brings its own points (STL)
  std::vector<std::string> notes;

  /// The corners added since the last face are a face.
  void end_face() { face_ends.push_back(static_cast<int>(corners.size())); }
};

}  // namespace epura::mesh
