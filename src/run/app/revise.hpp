// SPDX-License-Identifier: Apache-2.0
// A drawing that shows what differs from an older version of its model: clouds, and a row in the table of revisions.
#pragma once

#include <string>
#include <vector>

#include "app/options.hpp"
#include "composition/finished_sheet.hpp"
#include "scene/description.hpp"
#include "sheet/rectangle.hpp"
#include "views/messages.hpp"

namespace epura {

struct Revised {
  std::string revision;                                  ///< "B"
  std::vector<std::vector<sheet::Rectangle>> changes{};  ///< by sheet
};

/// Draws both versions and compares them. Unless they are the same, the scene gets a row for it, if it has none of this
/// revision: that of the title block, or the one after the last. Throws Error.
Revised revise(const DrawOptions& options, scene::SceneDescription& scene, const pipeline::Messages& messages);

/// Draws the clouds.
void add_clouds(std::vector<pipeline::FinishedSheet>& sheets, const Revised& revised);

}  // namespace epura
