// SPDX-License-Identifier: Apache-2.0
// A projection seen from outside, as a scene that is drawn like any other: the model, its image on the picture plane,
// rays, the view volume and the normalised volume are models, named by labels.
#pragma once

#include <optional>
#include <vector>

#include "construction/set_up.hpp"
#include "pipeline/draw_scene.hpp"

namespace epura::pipeline {

struct PictureRequest {
  scene::ModelDescription model{};
  scene::Located<scene::ProjectionRequest> projection{};  ///< that is shown
  scene::Located<scene::ProjectionRequest> from{};        ///< that shows it, parallel; by default a view from the side
  scene::Located<std::vector<int>> vertices{};            ///< of the model, through which rays run; by default chosen
  bool keeps_plane = false;                               ///< the picture plane stays where it is
};

/// What a picture shows, and where from.
struct Picture {
  construction::SetUp set_up;
  projection::Projection projection;
  view::ViewingModel viewing;
  projection::ProjectionEntry entry;
  projection::Influence influence;
};

/// Draws the model with the projection, for its image. Throws Error.
Picture make_picture(const PictureRequest& request, const RunOptions& options, const Progress& progress);

/// The scene that shows it on one sheet, with a legend of the values. It needs views and sheets to be completed.
scene::SceneDescription scene_of(const Picture& picture, const PictureRequest& request);

}  // namespace epura::pipeline
