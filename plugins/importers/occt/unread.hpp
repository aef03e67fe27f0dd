// SPDX-License-Identifier: Apache-2.0
// What a file holds and this importer does not read: counted, so that nobody takes the drawing for all of it.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "step_graph.hpp"

namespace occt {

/// Sentences about views and layers of a STEP file, and what says more of requirements than `requirements_in_step` has
/// `read`. Shapes of triangles are counted: they stand beside exact ones.
std::vector<std::string> unread_in_step(std::string_view text, const std::set<EntityNumber>& read);

/// Why no shape could be read from a STEP file, if its shapes are of kinds that are not read, and what helps; otherwise
/// empty.
std::string unread_shapes_in_step(std::string_view text);

/// What `unread_in_step` says, of an IGES file.
std::vector<std::string> unread_in_iges(std::string_view text);

}  // namespace occt
