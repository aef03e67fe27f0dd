// SPDX-License-Identifier: Apache-2.0
// Requests for constructions -> figures of the views of a sheet.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "construction/epura.hpp"
#include "construction/figure.hpp"
#include "construction/request.hpp"
#include "view/projected_scene.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

/// Nothing if the sheet has another layout. Throws Error{input} if it lacks a front or a top view, or is in third
/// angle.
std::optional<EpuraViews> epura_views(const scene::SheetDescription& sheet, const SheetOfViews& views,
                                      std::span<const view::ProjectedScene> seen);

/// Throws Error{input} for constructions that no view for which they are requested can show: a horizon in a parallel
/// view, any in interrupted and detail views.
void expect_constructions(const SheetOfViews& views, std::span<const view::ProjectedScene> seen);

/// The figure of a view on its own, of what fits its projection; `scale` as of drawing::ViewDrawing.
construction::Figure figure_of_view(const world::World& world, const scene::ViewDescription& view,
                                    const construction::PicturePlane& plane, double factor,
                                    const construction::Surroundings& around);

/// The same in the plane of the view, in units of the world, from the origin of view::drawn_box.
construction::Figure figure_in_plane(const world::World& world, const scene::ViewDescription& view,
                                     const view::ProjectedScene& seen);

/// The same on paper.
construction::Figure figure_on_paper(const world::World& world, const scene::ViewDescription& view,
                                     const drawing::ViewDrawing& drawing);

/// The boxes of elevation and plan with their constructions, as view::drawn_box.
std::array<projection::Window, 2> epura_boxes(const world::World& world, const SheetOfViews& views,
                                              std::span<const view::ProjectedScene> seen);

/// The figure of an épura whose ground line ends at `ends`.
construction::Figure figure_of_epura(const world::World& world, std::span<const scene::ViewDescription* const> views,
                                     const construction::Epura& epura);

}  // namespace epura::pipeline
