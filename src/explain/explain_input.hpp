// SPDX-License-Identifier: Apache-2.0
// One view with all that was computed on the way to its drawing: what questions about a drawing are asked of.
#pragma once

#include "drawing/drawing.hpp"
#include "drawing/make_drawing.hpp"
#include "edges/find_edges.hpp"
#include "scene/scene.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"

namespace epura::explain {

struct ExplainInput : visibility::ResolvedView {
  const edges::EdgeOptions& options;
  const view::PaperMap& paper;
  const drawing::ViewDrawing& drawing;
  bool keep_hidden;  ///< hidden lines are drawn, too
};

}  // namespace epura::explain
