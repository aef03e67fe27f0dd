// SPDX-License-Identifier: Apache-2.0
// Finds the edges that a question is about: by vertices, by faces, or by a position on the sheet.
#pragma once

#include <array>
#include <string_view>
#include <variant>
#include <vector>

#include "explain/subject.hpp"

namespace epura::explain {

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

/// Returns one edge, all intersection lines of two faces, or the three drawn edges nearest to a place, nearest first.
/// Throws Error{input} if there is none, with a hint at what there is instead.
std::vector<Subject> find_subjects(const ExplainInput& drawn_view, const EdgeQuestion& question);

}  // namespace epura::explain
