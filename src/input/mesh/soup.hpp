// SPDX-License-Identifier: Apache-2.0
// The raw content of a file: points, polygons as sequences of corner indices, and lines that bound no polygon.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/colour.hpp"

namespace epura::mesh {

using Points = std::vector<std::array<double, 3>>;

struct Soup {
  Points points;
  std::vector<int> corners;    ///< corner indices of all faces, one face after the other, all in range
  std::vector<int> face_ends;  ///< end of each face in `corners`
  std::vector<int> face_body;  ///< named group of each face; empty if the file has no names
  std::vector<std::string> body_names;
  std::vector<std::optional<Colour>> body_colours;  ///< of each named group; empty if the file has none
  /// The segments of wires between two points, in range. None if `corners_repeat_points`.
  std::vector<std::array<int, 2>> wires;
  std::vector<int> marked_points;  ///< points that are to be drawn as such, in range
  int wire_faces = 0;  ///< empty faces in place of wires and points, which preserve the numbers of the others
  std::string format;  ///< "obj", "stl", "ply", "off"
  bool single_precision = false;       ///< coordinates are stored in 32 bits
  bool printed = false;                ///< coordinates were written as text, hence possibly rounded to decimals
  bool corners_repeat_points = false;  ///< every face has its own points (STL)
  std::vector<std::string> notes;

  /// Makes a face of the corners added since the last one.
  void end_face() { face_ends.push_back(static_cast<int>(corners.size())); }

  /// Adds a wire through these points.
  template <class Numbers>
  void add_wire(const Numbers& numbers) {
    for (std::size_t i = 1; i < numbers.size(); ++i)
      wires.push_back({static_cast<int>(numbers[i - 1]), static_cast<int>(numbers[i])});
  }
};

}  // namespace epura::mesh
