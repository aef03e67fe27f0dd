// SPDX-License-Identifier: Apache-2.0
// Which faces of a part the dimensions of its sheets measure, and which can move, turn or grow although all hold.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "definition/rules.hpp"
#include "features/true_extents.hpp"
#include "report/report.hpp"
#include "sheet/notation.hpp"
#include "sizes/coverage.hpp"

namespace epura::sheet {

/// What faces can do.
struct FreeFace {
  std::string sentence;
  int face;                ///< of the model, by which it is named
  int number;              ///< of that in scenes (surfaces/numbers.hpp)
  std::vector<int> faces;  ///< of the model, that do it
};

struct FreeFaces {
  std::vector<FreeFace> free;
  std::vector<int> numbers;                                   ///< of all faces of the model in scenes
  std::vector<char> held;                                     ///< by face of the model: whether dimensions hold it
  std::vector<std::string> repeated;                          ///< dimensions that follow from others, and from which
  std::vector<std::string> undecided;                         ///< what keeps anyone from telling
  std::vector<std::string> contradictory;                     ///< dimensions that cannot all be true
  report::SizeCount count{"faces held by dimensions", 0, 0};  ///< of all kinds; none of free forms
};

/// By the rank of what the dimensions and rules that readers apply say of the faces, without regard to features. Faces
/// of which only a doubtful reading of a text holds one are not counted as held; and where nobody can tell what a
/// dimension measures, `undecided` says so instead of those that would be free without it. Each sentence ends with a
/// view in which what is missing can be given. Nothing for an assembly.
FreeFaces find_free_faces(std::span<const DimensionsInView> views, const world::World& world,
                          const std::array<features::Extent, 3>& extents, const Notation& notation,
                          const definition::RuleSet& rules);

/// The faces that each dimension measures, by view and dimension, as their numbers in scenes in ascending order: by the
/// first of its readings. None where nobody can tell, and where find_free_faces says nothing.
std::vector<std::vector<std::vector<int>>> measured_faces(std::span<const DimensionsInView> views,
                                                          const world::World& world,
                                                          const std::array<features::Extent, 3>& extents,
                                                          const Notation& notation);

}  // namespace epura::sheet
