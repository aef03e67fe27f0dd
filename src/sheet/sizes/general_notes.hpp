// SPDX-License-Identifier: Apache-2.0
// Judges notes without a leader: of all fillets, holes, threads or chamfers of the models that no other text gives, of
// some of them, and of lengths and thicknesses: "all fillets R2", "4× M8 ↧15", "plate 5 thick".
#pragma once

#include <vector>

#include "sizes/hole_judge.hpp"

namespace epura::sheet {

/// What another text says of a circle.
struct GivenSize {
  WorldCircle circle;
  NotedText text;
};

using OtherTexts = std::vector<GivenSize>;

/// What differs from the note has to be given elsewhere; and something has to be as it says.
void judge_of_kind(Verdict& verdict, const NotedText& note, const OtherTexts& given, const HoleWalls& walls,
                   const world::World& world, const Notation& notation);

}  // namespace epura::sheet
