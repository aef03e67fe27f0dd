// SPDX-License-Identifier: Apache-2.0
// The lines of annotations of a STEP file: pictures of what it does not say in words.
#pragma once

#include <string_view>
#include <vector>

#include "model.hpp"
#include "step_graph.hpp"

namespace occt {

/// Annotations of a file.
struct Pictures {
  std::vector<EntityNumber> annotations{};
  double length_unit = 1;  ///< of their coordinates, mm
};

/// Whether no part is moved: annotations of others would need to be placed.
bool may_have_pictures(const Model& model);

/// Adds a part for each of these annotations, whose lines are its wires, if the model may have them. Returns how many
/// have lines that are read: polylines, and those of tessellated curves.
std::size_t add_pictures(Model& model, std::string_view text, const Pictures& pictures);

}  // namespace occt
