// SPDX-License-Identifier: Apache-2.0
// Notes of a STEP file: words of annotations that show no other requirement, and properties that are notes.
#pragma once

#include <cstddef>
#include <vector>

#include "model.hpp"
#include "requirement_index.hpp"
#include "step_graph.hpp"

namespace occt {

/// In the order of their numbers. Those whose annotation belongs to aspects of the shape have their items, as many as
/// `items_left`; the others are about the whole part.
std::vector<Requirement> notes_in_step(const StepGraph& graph, const RequirementIndex& index, std::size_t& items_left);

}  // namespace occt
