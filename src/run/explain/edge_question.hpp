// SPDX-License-Identifier: Apache-2.0
// The words by which a question names an edge.
#pragma once

#include <array>
#include <string_view>
#include <variant>

#include "base/vec.hpp"

namespace epura::explain {

/// A face of a file: the number of its model and its own number; -1 for one that a section leaves out.
using FaceName = std::array<int, 2>;

/// "MODEL:VERTEX-VERTEX", or without "MODEL:" for model 0.
struct ByVertices {
  int model;
  std::array<int, 2> vertex;
};

/// "MODEL:FACExMODEL:FACE", an intersection line.
struct ByFaces {
  std::array<FaceName, 2> faces;
};

/// "@X,Y": mm from the lower left corner, y up.
struct ByPlace {
  Vec2 place;
};

using EdgeQuestion = std::variant<ByVertices, ByFaces, ByPlace>;

/// Throws Error{input} if the text has none of these forms.
EdgeQuestion parse_edge_question(std::string_view text);

}  // namespace epura::explain
