// SPDX-License-Identifier: Apache-2.0
#include "pipeline/lint.hpp"

#include <cstddef>
#include <string>

#include "scene/design_features.hpp"
#include "scene/true_extents.hpp"

namespace epura::pipeline {

std::vector<sheet::DimensionsInView> anchored_dimensions(const scene::World& world, const SheetOfViews& sheet,
                                                         std::span<const view::ProjectedScene> seen,
                                                         std::span<const Annotations> annotations) {
  std::vector<sheet::DimensionsInView> views;
  for (std::size_t i = 0; i < seen.size(); ++i)
    views.push_back(
        {*sheet.descriptions[i].name, seen[i].projection, sheet::find_anchors(world, annotations[i].dimensions)});
  return views;
}

std::vector<report::Finding> uncovered_sizes(const scene::World& world, const scene::SceneDescription& scene,
                                             std::span<const sheet::DimensionsInView> views, const Progress& progress) {
  const scene::DesignFeatures features = scene::find_design_features(world, progress);
  const auto extents = scene::true_extents(world);
  const sheet::Coverage coverage =
      sheet::find_coverage(views, {world, features, extents}, notation_of(world, scene.sheets.front()));
  std::vector<report::Finding> findings;
  for (const std::string& what : coverage.undimensioned)
    findings.push_back({report::FindingKind::undimensioned, "", what});
  for (const std::string& what : coverage.repeated) findings.push_back({report::FindingKind::repeated, "", what});
  return findings;
}

}  // namespace epura::pipeline
