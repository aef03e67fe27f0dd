// SPDX-License-Identifier: Apache-2.0
// Details of the views on a sheet.
#pragma once

#include <span>
#include <vector>

#include "drawing/boundary.hpp"
#include "pipeline/layout.hpp"
#include "pipeline/messages.hpp"

namespace epura::pipeline {

/// The boundary of a detail in a parallel view.
drawing::Boundary boundary_on_page(const scene::DetailDescription& detail, const drawing::ViewDrawing& drawing);

/// The box of a detail's boundary in the plane of a parallel view, in units and from the origin of view::drawn_box.
sheet::Rectangle boundary_box(const scene::DetailDescription& detail, const view::ProjectedScene& view);

/// The drawn box of a view in its plane; of a detail, the box of its boundary. Units and origin are those of
/// view::drawn_box. Throws Error{input} for details of perspectives, and for those outside what the view shows.
projection::Window box_to_place(const ViewOptions& options, const view::ProjectedScene& view,
                                const world::World& world);

/// Warns of details that are not larger than in the view that they enlarge.
void warn_about_details(const Messages& messages, const SheetOfViews& views, const SheetPlan& plan);

/// Appends the boundaries of the details on a sheet, and their marks in the views that they enlarge, to the layers of
/// all that is drawn there already.
void add_details(std::vector<sheet::Layer>& layers, const SheetInput& input,
                 std::span<const drawing::ViewDrawing> drawings);

}  // namespace epura::pipeline
