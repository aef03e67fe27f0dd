// Dimensions of a scene -> those of each view of a sheet.
#pragma once

#include <span>
#include <vector>

#include "scene/description.hpp"
#include "view/view.hpp"

namespace epura {

using DimensionsByView = std::vector<std::vector<DimensionDescription>>;

/// By view of the sheet (from 0), `seen` and described by `views`. A dimension without a view belongs to the first one
/// of the scene; overall ones without view and direction stand on the first sheet. Throws Error{input} for overall
/// ones that no view shows.
DimensionsByView dimensions_by_view(const SceneDescription& scene, int sheet, std::span<const ViewDescription> views,
                                    std::span<const View> seen);

/// Throws Error{input} for dimensions in views that are not there.
void expect_views_of_dimensions(const SceneDescription& scene);

}  // namespace epura
