// SPDX-License-Identifier: Apache-2.0
#include "pipeline/place_view.hpp"

#include <utility>
#include <vector>

#include "base/error.hpp"
#include "composition/annotations.hpp"
#include "composition/layout.hpp"
#include "pipeline/read_models.hpp"
#include "pipeline/recognise_parts.hpp"
#include "views/constructions.hpp"
#include "views/view_plan.hpp"

namespace epura::pipeline {

world::World read_world(const scene::SceneDescription& scene, const RunOptions& options, const Messages& messages,
                        Progress progress) {
  report::Report report;
  ReadWorld read = read_models(scene, reading_of(scene, options), report.meshes, messages, progress);
  recognise_parts(read.world, scene, options, report, progress);
  doubt_unit(messages, scene, read.world, read.without_unit);
  return std::move(read.world);
}

PlacedView place_view(const world::World& world, const scene::SceneDescription& scene, const RunOptions& options) {
  check(scene.views.size() == 1 && scene.sections.empty() && scene.explosions.empty(),
        "one view shows the models whole");
  const SheetOfViews sheet = views_by_sheet(scene, plan_views(scene, options)).front();
  std::vector<view::ProjectedScene> seen{project_scene(world, sheet.plans.front(), sheet.descriptions.front())};
  expect_constructions(sheet, seen);
  const SheetPlan plan = plan_sheet(world, scene, sheet, seen, annotate(world, scene, sheet, seen, {}));
  const sheet::Paper& paper = plan.furniture.paper;
  return {std::move(seen.front()), sheet.plans.front().options.edges, plan.places.front(), {paper.width, paper.height}};
}

}  // namespace epura::pipeline
