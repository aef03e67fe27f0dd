// SPDX-License-Identifier: Apache-2.0
// Reads one part of an OBJ file independently of what precedes it: long files are read in parallel parts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

/// A name for the faces that follow.
struct ObjNaming {
  std::size_t first_face;
  std::string_view name;  ///< part of the text
};

/// A corner that refers to its vertex by a negative number, counted back from the last vertex before it.
struct ObjRelativeCorner {
  std::size_t corner;
  std::size_t vertices_before;
  long long number;
  std::size_t line;
};

/// Lines whose keyword describes neither surfaces nor wires and is not one of the usual ones.
struct ObjIgnored {
  std::vector<std::string> keywords;  ///< the first few
  std::size_t lines = 0;
  std::size_t first_line = 0;
};

/// Vertex sequences of one kind of element, one after the other.
struct ObjElements {
  std::vector<int> corners;  ///< vertices of the file; placeholders for relative ones
  std::vector<int> ends;     ///< end of each element in `corners`
  std::vector<ObjRelativeCorner> relative;
  long long largest = -1;  ///< largest vertex number of a corner
  std::size_t largest_line = 0;
};

/// Names of elements in error messages.
inline constexpr const char* obj_face = "a face";
inline constexpr const char* obj_wire = "a line";
inline constexpr const char* obj_point = "a point";

/// Faces, corners, vertices before a corner and lines are counted from the beginning of the part, lines from 0.
struct ObjPart {
  Points points;
  ObjElements faces, wires, marks;
  std::vector<ObjNaming> objects, groups;
  ObjIgnored ignored;
  std::size_t lines = 0;
};

/// `name` denotes the file in errors, `first_line` is the line where the part begins, counted from 1. The result refers
/// to `text`. Throws Error on a line that is not OBJ.
ObjPart read_obj_part(std::string_view text, std::string_view name, std::size_t first_line);

/// Adds the ignored lines of a part that begins `lines_before` lines later.
void join(ObjIgnored& ignored, const ObjIgnored& later, std::size_t lines_before);

}  // namespace epura::mesh
