// SPDX-License-Identifier: Apache-2.0
// Which triangles are lines on the page, as far as the page grid and the files tell.
#pragma once

#include <array>

#include "view/projected_scene.hpp"

namespace epura::view {

/// Returns the distance on the page (view units) below which the side of a line on which a point lies is uncertain
/// because of the page grid.
double grid_resolution(const ProjectedScene& view);

/// Returns the same distance because of the page grid or, if larger, the effect of rounding in the files.
double page_resolution(const world::World& world, const ProjectedScene& view);

/// Returns the height of a triangle above its longest side on the page (view units); NaN if it extends behind the
/// viewer.
double height_on_page(const ProjectedScene& view, const std::array<int, 3>& corners);

}  // namespace epura::view
