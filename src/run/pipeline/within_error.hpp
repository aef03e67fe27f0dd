// SPDX-License-Identifier: Apache-2.0
// --max-error: finer facets until lines are near enough to the surfaces.
#pragma once

#include <functional>
#include <vector>

#include "pipeline/draw_scene.hpp"
#include "views/view_error.hpp"

namespace epura::pipeline {

/// Of models as they were read; importers choose facets.
Facets facets_of(const std::vector<mesh::MeshReport>& meshes);

using DrawWithFacets = std::function<DrawnScene(double facets, const Messages& messages)>;

/// Calls `draw` with `usual_facets`, and again with finer ones while it throws TooFar: lines are farther off than
/// `max_error`, mm on paper. Attempts hardly depend on it, so it is known which one is kept. Surfaces are certain to
/// `certain`, a part of the drawing. Throws Error{input} with a value that is kept if finer facets do not help: at once
/// where no facets, however fine, would.
DrawnScene draw_within_error(double max_error, double certain, const Messages& messages, const DrawWithFacets& draw);

}  // namespace epura::pipeline
