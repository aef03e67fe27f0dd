// SPDX-License-Identifier: Apache-2.0
// Notes of a STEP file: words of annotations that show no other requirement, and properties that are notes.
#pragma once

#include <cstddef>
#include <vector>

#include "model.hpp"
#include "requirement_index.hpp"
#include "step_graph.hpp"
#include "step_pictures.hpp"

namespace occt {

struct Notes {
  std::vector<Requirement> all{};  ///< in the order of their numbers
  Pictures wordless{};             ///< that show no requirement either: callouts, if there are any
};

/// Notes whose annotation belongs to aspects of the shape have their items, as many as `items_left`; the others are
/// about the whole part.
Notes notes_in_step(const StepGraph& graph, const RequirementIndex& index, std::size_t& items_left);

}  // namespace occt
