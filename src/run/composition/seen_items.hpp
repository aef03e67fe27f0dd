// SPDX-License-Identifier: Apache-2.0
// Where the items of a parts list are best seen in a view: where leaders of balloons end.
#pragma once

#include <optional>
#include <vector>

#include "annotations/balloons.hpp"
#include "drawing/drawing.hpp"
#include "importer/assemble.hpp"
#include "scene/description.hpp"
#include "views/messages.hpp"
#include "views/view_plan.hpp"
#include "world/items.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// The items of the parts list, if it is on this sheet; `parts` are the bodies of each model. Warns of open surfaces
/// that are in none.
std::vector<world::Item> listed_items(const world::World& world, const scene::SceneDescription& scene,
                                      const std::vector<std::vector<importer::BodyPart>>& parts, int sheet,
                                      const Messages& messages);

/// A point of an item that nothing hides.
struct SeenPoint {
  Vec2 at;      ///< on paper
  double free;  ///< mm from there to lines of the drawing and to other bodies; 0 on a line
  bool on_line = false;
};

/// By item. On a face, as far from lines as possible; the faces are compared at the points of a grid. An item whose
/// faces are too small or seen edge-on has a point on its longest visible line. `world` is what the view shows, with
/// the bodies of the items.
std::vector<std::optional<SeenPoint>> seen_items(const world::World& world, const drawing::ViewDrawing& drawing,
                                                 const std::vector<world::Item>& items);

/// By view: the balloons of the items, each in the view of `seen` that shows it best; in that of the parts list, if it
/// shows it. Views in which nothing was looked for are empty. Warns of items that no view shows.
std::vector<std::vector<sheet::BalloonTarget>> balloons_of(
    const scene::SceneDescription& scene, const SheetOfViews& views,
    const std::vector<std::vector<std::optional<SeenPoint>>>& seen, const Messages& messages);

}  // namespace epura::pipeline
