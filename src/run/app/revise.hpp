// SPDX-License-Identifier: Apache-2.0
// A drawing that shows what differs from an older version of its model: clouds, and a row in the table of revisions.
#pragma once

#include <string>

#include "app/options.hpp"
#include "pipeline/draw_scene.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"

namespace epura {

/// The older version of a drawing that is to be made.
struct Revising {
  std::string older_file, revision;  ///< "B"
  bool adds_row;                     ///< whether the scene has got a row for this revision
  scene::SceneDescription older;
};

/// Gives the scene a row without words for the revision, if it has none: that of the title block, or the one after the
/// last. Throws Error.
Revising begin_revision(const DrawOptions& options, scene::SceneDescription& scene);

/// Draws the older version on the sheets of the scene and compares them: clouds round what differs, and its words in
/// the row. If nothing differs, takes away the row. Returns false if the sheets must be drawn again for that.
bool mark_revision(Revising revising, const pipeline::RunOptions& options, scene::SceneDescription& scene,
                   pipeline::DrawnScene& drawn, const pipeline::Messages& messages);

}  // namespace epura
