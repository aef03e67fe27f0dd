// SPDX-License-Identifier: Apache-2.0
// What tolerances in a STEP file refer to.
#pragma once

#include <string>
#include <string_view>

#include "step_graph.hpp"

namespace occt {

/// The letter of a datum; "?" if the file has none.
std::string letter_of(const StepGraph& graph, EntityNumber datum);

/// The datums in an attribute of a tolerance, in their order: "A | B (maximum material) | C-D", where those of C-D are
/// one in common. Those that the file lacks are "?".
std::string datum_references(const StepGraph& graph, std::string_view list);

}  // namespace occt
