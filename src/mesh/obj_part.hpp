// SPDX-License-Identifier: Apache-2.0
// One part of an OBJ file, parsed independently of what precedes it: long files are read in parallel parts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/soup.hpp"

namespace epura::mesh {

/// A name for the faces that follow.
struct ObjNaming {
  std::size_t first_face;
  std::string_view name;  ///< a piece of the text
};

/// A corner that names its vertex by a negative number: it counts back from the last vertex before it.
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

/// Runs of vertices of one kind of element, one after the other.
struct ObjElements {
  std::vector<int> corners;  ///< vertices of the file, but for the relative ones
  std::vector<int> ends;     ///< where each element ends in `corners`
  std::vector<ObjRelativeCorner> relative;
  long long largest = -1;  ///< vertex that a corner names
  std::size_t largest_line = 0;
};

/// What errors call an element.
inline constexpr const char* obj_face = "a face";
inline constexpr const char* obj_wire = "a line";

/// Faces, corners, vertices before a corner and lines count from the beginning of the part, lines from 0.
struct ObjPart {
  Points points;
  ObjElements faces, wires;
  std::vector<ObjNaming> objects, groups;
  ObjIgnored ignored;
  std::size_t lines = 0;
};

/// `name` is the file in errors, `first_line` where the part begins in it, from 1. The result refers to `text`.
/// Throws Error on a line that is not OBJ.
ObjPart read_obj_part(std::string_view text, std::string_view name, std::size_t first_line);

/// Adds the lines of a part that begins `lines_before` lines later.
void join(ObjIgnored& ignored, const ObjIgnored& later, std::size_t lines_before);

}  // namespace epura::mesh
