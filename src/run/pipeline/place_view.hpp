// SPDX-License-Identifier: Apache-2.0
// Where one view of a scene lies on its sheet, before anything is drawn.
#pragma once

#include "base/progress.hpp"
#include "scene/description.hpp"
#include "views/draw_view.hpp"
#include "views/messages.hpp"
#include "views/options.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// The world that a drawing of the scene shows, uncut, with the faces of parts that decide which edges are drawn.
world::World read_world(const scene::SceneDescription& scene, const RunOptions& options, const Messages& messages,
                        Progress progress);

struct PlacedView {
  view::ProjectedScene seen;
  edges::EdgeOptions edges;  ///< what is drawn of it
  PlaceOnPage place;
  Vec2 paper;  ///< width and height of the sheet, mm
};

/// Places the only view of a scene that neither cuts nor explodes its models, as its drawing does. Throws Error.
PlacedView place_view(const world::World& world, const scene::SceneDescription& scene, const RunOptions& options);

}  // namespace epura::pipeline
