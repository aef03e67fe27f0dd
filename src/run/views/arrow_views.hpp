// SPDX-License-Identifier: Apache-2.0
// Auxiliary views placed beside their parents: the reference arrow method. ISO 128-3.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include "views/view_plan.hpp"

namespace epura::pipeline {

/// Turns each view with a parent such that lines perpendicular to its direction of sight are parallel in both views.
/// Throws Error{input} if the parent does not show that direction in true length, and if it is on another sheet.
void orient_arrow_views(SheetOfViews& sheet, const std::function<const world::World&(std::size_t)>& world);

/// The number of a view's parent on the sheet; nothing if it has none there.
std::optional<std::size_t> parent_of(const SheetOfViews& sheet, std::size_t view);

/// The image in a parallel view of the direction in which an auxiliary view is seen; length 1.
Vec2 sight_on_page(const projection::Projection& parent, const Vec3& from);

}  // namespace epura::pipeline
