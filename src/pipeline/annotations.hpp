// SPDX-License-Identifier: Apache-2.0
// Dimensions and sections of a scene -> annotations of each view on a sheet.
#pragma once

#include <span>
#include <vector>

#include "pipeline/sections.hpp"
#include "pipeline/view_plan.hpp"
#include "scene/description.hpp"
#include "view/projected_scene.hpp"

namespace epura::pipeline {

struct Annotations {
  std::vector<scene::DimensionDescription> dimensions;
  std::vector<scene::CuttingPlane> planes;  ///< of sections that are marked in this view
};

/// By view of the sheet, `seen` in its place. A dimension without a view belongs to the first one of the scene; overall
/// ones without view and direction are on the first sheet. A section that some view of the sheet shows is marked in
/// the first view of the whole that sees its plane edge-on. Throws Error{input} for overall dimensions that no view
/// shows.
std::vector<Annotations> annotate(const scene::World& world, const scene::SceneDescription& scene,
                                  const SheetOfViews& sheet, std::span<const view::ProjectedScene> seen,
                                  const CutSections& sections);

/// Throws Error{input} for dimensions in views that are not there.
void expect_views_of_dimensions(const scene::SceneDescription& scene);

}  // namespace epura::pipeline
