// SPDX-License-Identifier: Apache-2.0
// One view with all that was computed on the way to its drawing: what questions about a drawing are asked of.
#pragma once

#include "drawing/drawing.hpp"
#include "drawing/make_drawing.hpp"
#include "edges/drawn_edges.hpp"
#include "scene/scene.hpp"
#include "view/paper_map.hpp"
#include "view/projected_scene.hpp"
#include "visibility/visibility.hpp"

namespace epura {

struct ExplainInput {
  const World& world;
  const ProjectedScene& view;
  const EdgeOptions& wishes;
  const FeatureEdges& drawn;
  const HiddenSpans& hidden;
  const Contact& contact;
  const PaperMap& paper;
  const ViewDrawing& drawing;
  bool keep_hidden;  ///< hidden lines are drawn, too
};

}  // namespace epura
