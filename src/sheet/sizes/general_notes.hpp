// SPDX-License-Identifier: Apache-2.0
// Judges notes of all fillets, holes or chamfers of the models that no other text gives: "all fillets R2".
#pragma once

#include <vector>

#include "sizes/hole_judge.hpp"

namespace epura::sheet {

/// What another text says of a circle.
struct GivenSize {
  WorldCircle circle;
  NotedText text;
};

/// What differs from the note has to be given elsewhere; and something has to be as it says.
void judge_of_kind(Verdict& verdict, const NotedText& note, const std::vector<GivenSize>& given, const HoleWalls& walls,
                   const world::World& world, const Notation& notation);

}  // namespace epura::sheet
