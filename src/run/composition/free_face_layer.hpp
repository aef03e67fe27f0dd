// SPDX-License-Identifier: Apache-2.0
// Hatching of faces on which nothing on the sheets has a hold, where a view shows them.
#pragma once

#include <span>
#include <vector>

#include "composition/finished_sheet.hpp"
#include "drawing/view_drawing.hpp"
#include "sheet/sheet.hpp"
#include "views/shown_worlds.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// Hatched faces of the first model of a scene, by their indices in its part.
struct HatchedFaces {
  std::vector<int> faces;
  std::vector<int> numbers;  ///< of all faces of the part, in scenes
};

/// Layer "VIEW/free" with red lines on what a view shows of the faces, and their numbers; `world` is the one that it
/// shows. Nothing on details and on views with breaks.
sheet::Layer free_face_layer(const drawing::ViewDrawing& drawing, const world::World& world,
                             const HatchedFaces& hatched, double line_width);

/// Puts these layers below all others of the sheets.
void hatch_free_faces(std::span<FinishedSheet> sheets, const scene::SceneDescription& scene, const ShownWorlds& worlds,
                      const HatchedFaces& hatched);

}  // namespace epura::pipeline
