// SPDX-License-Identifier: Apache-2.0
// Details: what part of a view they show.
#pragma once

#include "drawing/boundary.hpp"
#include "sheet/rectangle.hpp"
#include "views/draw_view.hpp"

namespace epura::pipeline {

/// The boundary of a detail in a parallel view.
drawing::Boundary boundary_on_page(const scene::DetailDescription& detail, const drawing::ViewDrawing& drawing);

/// The box of a detail's boundary in the plane of a parallel view, in units and from the origin of view::drawn_box.
sheet::Rectangle boundary_box(const scene::DetailDescription& detail, const view::ProjectedScene& view);

/// The drawn box of a view in its plane; of a detail, the box of its boundary. Units and origin are those of
/// view::drawn_box. Throws Error{input} for details of perspectives, and for those outside what the view shows.
projection::Window box_to_place(const ViewOptions& options, const view::ProjectedScene& view,
                                const world::World& world);

}  // namespace epura::pipeline
