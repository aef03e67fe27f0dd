// SPDX-License-Identifier: Apache-2.0
// Dimensions, geometric tolerances, datums, surface textures and notes of a STEP file (ISO 10303-242, ISO 10303-47), as
// its text states them.
//
// They are not taken from XCAF: Open CASCADE 7.6 loses the values of tolerances that are given as items of a
// representation, does not convert nominal values of files in inches but their deviations, and knows no decimals.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "model.hpp"
#include "step_graph.hpp"
#include "step_pictures.hpp"

namespace occt {

struct StepRequirements {
  std::vector<Requirement> all{};  ///< in the order of their numbers, surface textures and notes last
  Pictures pictures{};             ///< that show none of them
  std::set<EntityNumber> read{};   ///< statements about them which `unread_in_step` would count otherwise
  std::string standard{};          ///< of dimensions and tolerances; empty: the file names none
};

/// All are there; what could not be read of one is said in `missing`.
StepRequirements requirements_in_step(std::string_view text);

bool is_dimension(std::string_view keyword);
bool is_tolerance(std::string_view keyword);
bool is_datum(std::string_view keyword);

}  // namespace occt
