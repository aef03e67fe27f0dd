// SPDX-License-Identifier: Apache-2.0
// Surface textures of a STEP file, as ISO 10303-1110 maps them: a property of an aspect of the shape or of the whole
// part says whether material is removed, and properties related to it have a parameter each, such as Ra.
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "model.hpp"
#include "requirement_index.hpp"
#include "step_graph.hpp"

namespace occt {

/// In the order of their numbers; parameters that no property leads to are ones of their own. Their representations are
/// added to `read`. Those of aspects have their items, as many as `items_left`.
std::vector<Requirement> textures_in_step(const StepGraph& graph, const RequirementIndex& index,
                                          std::size_t& items_left, std::set<EntityNumber>& read);

}  // namespace occt
