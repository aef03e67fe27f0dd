// SPDX-License-Identifier: Apache-2.0
// Judges what texts of dimensions and notes state by the faces to which they are attached, of parts and assemblies.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sheet/notation.hpp"
#include "sizes/dimensions_in_view.hpp"
#include "world/world.hpp"

namespace epura::sheet {

/// A sentence for each text.
struct JudgedTexts {
  std::vector<std::string> untrue;    ///< that states what the models have not, and what they have
  std::vector<std::string> unjudged;  ///< of which nobody can tell, or of a part of which
};

/// Each size by its kind, its unit and to its last digit, between limits, in brackets, too; each count; of notes of
/// holes each depth, recess, angle and thread by the walls around the same axis. What is not understood is told.
/// Notes without a leader, `general`, where they speak of all fillets, holes or chamfers.
JudgedTexts judge_texts(std::span<const DimensionsInView> views, std::span<const std::string> general,
                        const world::World& world, const Notation& notation);

}  // namespace epura::sheet
