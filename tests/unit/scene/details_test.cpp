// SPDX-License-Identifier: Apache-2.0
#include "scene/details.hpp"

#include <gtest/gtest.h>

#include "scene/part_options.hpp"

namespace epura::scene::details_test {
namespace {

/// A view and an enlarged part of it.
SceneDescription view_and_detail(const ViewDescription& whole) {
  SceneDescription scene;
  scene.views = {whole, {}};
  scene.views[0].name = {"whole", ""};
  scene.views[1].name = {"part", ""};
  scene.views[1].detail = {"X", ""};
  scene.views[1].scale = {ScaleChoice{5.0, false}, ""};
  scene.details.push_back({{"X", ""}});
  scene.details[0].radius = {3, ""};
  return scene;
}

ViewDescription with_all_lines() {
  ViewDescription view;
  view.projection = {ProjectionRequest{"front"}, ""};
  view.hidden = {HiddenLines::solid, ""};
  view.hatch = {HatchPattern::steel, ""};
  view.edges = {EdgeKinds{.tangent = true}, ""};
  view.crease_angle = {7, ""};
  view.weak_crease_angle = {8, ""};
  view.least_crease = {9, ""};
  view.join_within = {0.5, ""};
  view.layers = {LayersBy::body, ""};
  view.construction = {ConstructionChoice(), ""};
  view.centre_of_gravity = {true, ""};
  view.centre_lines = {true, ""};
  view.near = {-5, ""};
  view.far = {5, ""};
  return view;
}

TEST(Details, HaveTheLinesOfTheirParents) {
  // All of them, also the next one that is added.
  const ViewDescription parent = with_all_lines();
  ASSERT_EQ(line_options().size(), 13U) << "give the new option a value here";
  SceneDescription scene = view_and_detail(parent);
  scene.views[1].least_crease = {1, "its own"};
  complete_details(scene);
  const ViewDescription& detail = scene.views[1];
  EXPECT_EQ(detail.hidden.value, HiddenLines::solid);
  EXPECT_EQ(detail.hatch.value, HatchPattern::steel);
  EXPECT_EQ(detail.edges.value, EdgeKinds{.tangent = true});
  EXPECT_EQ(detail.crease_angle.value, 7);
  EXPECT_EQ(detail.weak_crease_angle.value, 8);
  EXPECT_EQ(detail.least_crease.value, 1);
  EXPECT_EQ(detail.join_within.value, 0.5);
  EXPECT_EQ(detail.layers.value, LayersBy::body);
  EXPECT_EQ(detail.centre_lines.value, true);
  EXPECT_EQ(detail.near.value, -5);
  EXPECT_EQ(detail.far.value, 5);
  EXPECT_EQ(detail.projection->name, "front");
  EXPECT_FALSE(detail.construction.given());
  EXPECT_FALSE(detail.centre_of_gravity.given());
  EXPECT_EQ(detail.name.value, "part");
}

TEST(Details, WithoutOptionsLeaveThemOpen) {
  ViewDescription parent;
  parent.projection = {ProjectionRequest{"front"}, ""};
  SceneDescription scene = view_and_detail(parent);
  complete_details(scene);
  EXPECT_FALSE(scene.views[1].hatch.given());
  EXPECT_FALSE(scene.views[1].edges.given());
}

}  // namespace
}  // namespace epura::scene::details_test
