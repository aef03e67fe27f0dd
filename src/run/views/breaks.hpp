// SPDX-License-Identifier: Apache-2.0
// Interrupted, partial, half views: what a view leaves out. ISO 128-3.
#pragma once

#include <functional>
#include <span>

#include "drawing/breaks.hpp"
#include "scene/description.hpp"
#include "view/projected_scene.hpp"
#include "views/view_plan.hpp"
#include "world/world.hpp"

namespace epura::pipeline {

/// mm on paper between the parts of an interrupted view: more than the zigzags on both sides of it take, on all sheets.
inline constexpr double break_gap = 6;

/// What a view leaves out, in units and from the origin of view::drawn_box, without gaps. `auto` shortens stretches
/// that have a constant section and are more than three times as long as the view is wide across; on either side, as
/// much as that width remains. Details are never broken. Throws Error{input} for pictorial views, for places on axes
/// that the view does not show horizontally or vertically, and for breaks that leave nothing out, or everything.
drawing::Breaks find_breaks(const scene::ViewDescription& view, const view::ProjectedScene& seen,
                            const world::World& world);

/// Finds what all views of a sheet leave out.
void find_breaks(SheetOfViews& sheet, std::span<const view::ProjectedScene> seen,
                 const std::function<const world::World&(std::size_t)>& world);

/// Whether an automatic dimension measures to a point that the view leaves out.
bool is_left_out(const scene::DimensionDescription& dimension, const world::World& world, const drawing::Breaks& breaks,
                 const view::ProjectedScene& seen);

}  // namespace epura::pipeline
