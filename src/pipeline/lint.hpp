// SPDX-License-Identifier: Apache-2.0
// Checks the dimensions of a whole drawing against the features of its models.
#pragma once

#include <span>
#include <vector>

#include "pipeline/annotations.hpp"
#include "pipeline/view_plan.hpp"
#include "report/report.hpp"
#include "sheet/dimensions/coverage.hpp"
#include "view/projected_scene.hpp"

namespace epura::pipeline {

/// The dimensions of a sheet by view; `seen` and `annotations` are in the order of the views. Throws Error{input}: see
/// sheet/dimensions/anchors.hpp.
std::vector<sheet::DimensionsInView> anchored_dimensions(const world::World& world, const SheetOfViews& sheet,
                                                         std::span<const view::ProjectedScene> seen,
                                                         std::span<const Annotations> annotations);

/// Takes out dimensions by their numbers in each view.
void leave_out(std::span<sheet::DimensionsInView> views, std::span<const std::vector<std::size_t>> numbers);

/// Sizes of features that have no dimension, or several. Throws OutOfTime.
std::vector<report::Finding> uncovered_sizes(const world::World& world, const scene::SceneDescription& scene,
                                             std::span<const sheet::DimensionsInView> views, const Progress& progress);

/// Faces of free form that no tolerance gives.
std::vector<report::Finding> undefined_free_forms(const world::World& world, const scene::SceneDescription& scene);

}  // namespace epura::pipeline
