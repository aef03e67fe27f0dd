// SPDX-License-Identifier: Apache-2.0
#include "edges/find_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "cut/cut_world.hpp"
#include "shapes.hpp"

namespace epura::test::find_edges_test {
namespace {

edges::FeatureEdges edges_of(const world::World& world, view::ProjectedScene& view,
                             const edges::EdgeOptions& options = {}) {
  return edges::find_feature_edges(world, view, options);
}

TEST(FeatureEdges, KnowWhereTheyComeFrom) {
  const world::World world = world_of({box({0, 0, 0}, {1, 1, 1}), box({3, 0, 0}, {4, 1, 1})});
  view::ProjectedScene view = view::project_scene(world, orthographic({1.1, -2, 1.3}), {});
  const edges::FeatureEdges drawn = edges_of(world, view);
  ASSERT_EQ(drawn.edges.size(), 24U);
  for (std::size_t e = 0; e < drawn.edges.size(); ++e) {
    const edges::FeatureEdge& edge = drawn.edges[e];
    EXPECT_EQ(edge.model, e < 12 ? 0 : 1);
    EXPECT_EQ(edge.t, (std::array{0.0, 1.0}));
    EXPECT_EQ(edge.crossing, -1);
    const mesh::MeshEdge& mesh_edge = world.models[edge.model].mesh->edges[edge.mesh_edge];
    EXPECT_EQ(edge.vertex[0], mesh_edge.vertex[0] + world.first_vertex[edge.model]);
    EXPECT_EQ(edge.vertex[1], mesh_edge.vertex[1] + world.first_vertex[edge.model]);
  }
}

TEST(FeatureEdges, CrossingPlatesHaveALineInCommon) {
  Shape plates = plate(-1, -1, 1, 1, 0);
  plates.add({{{0.25, -2, -1}, {0.25, 2, -1}, {0.25, 2, 1}, {0.25, -2, 1}}, {{0, 1, 2, 3}}, {}});
  const world::World world = world_of(plates);
  view::ProjectedScene view = view::project_scene(world, orthographic({1.1, -2, 1.3}), {});
  const edges::FeatureEdges drawn = edges_of(world, view);
  double length = 0;
  int lines = 0;
  for (const edges::FeatureEdge& edge : drawn.edges) {
    if (edge.kind != EdgeKind::intersection) continue;
    ++lines;
    EXPECT_EQ(edge.mesh_edge, -1);
    const edges::FaceCrossing& crossing = drawn.crossings.at(edge.crossing);
    for (const Vec3& end : crossing.ends) {
      EXPECT_NEAR(end.x, 0.25, 1e-15);
      EXPECT_NEAR(end.z, 0, 1e-15);
    }
    EXPECT_LT(crossing.triangles[0], crossing.triangles[1]);
    EXPECT_NEAR(crossing.angle, 90, 1e-9);
    length += glm::length(crossing.ends[1] - crossing.ends[0]);
  }
  EXPECT_GT(lines, 0);
  EXPECT_NEAR(length, 2, 1e-12);
  view::ProjectedScene other = view::project_scene(world, orthographic({1.1, -2, 1.3}), {});
  EXPECT_EQ(edges_of(world, other, {.intersection = false}).edges.size(), drawn.edges.size() - lines);
}

TEST(FeatureEdges, OutsideTheWindowNothingIsDrawn) {
  const world::World world = world_of(plate(-10, -10, 10, 10, 0));
  projection::Projection p = from_above();
  p.window = projection::Window{{0, 0}, {20, 20}};
  view::ProjectedScene view = view::project_scene(world, p, {});
  const edges::FeatureEdges drawn = edges_of(world, view);
  ASSERT_EQ(drawn.edges.size(), 2U);
  for (const edges::FeatureEdge& edge : drawn.edges)
    EXPECT_NEAR(edge.t[1] - edge.t[0], 0.5, 1e-15) << "half of each border lies in the window";
}

// Of a plate that is cut at x = 2, the window shows what lies left of x = 5: of edges from -10 to 10, the part from 0.6
// to 0.75.
TEST(FeatureEdges, HaveTheParametersOfTheWholeEdgeWhereTheyAreCutTwice) {
  const world::World whole = world_of(plate(-10, -10, 10, 10, 0));
  const auto plane = scene::make_cutting_plane({{"A", "--section"}, Vec3(2, 0, 0), Vec3(-1, 0, 0)});
  const world::World world = cut::cut_world(whole, plane).world;
  projection::Projection p = from_above();
  p.window = projection::Window{{-5, -20}, {5, 20}};
  view::ProjectedScene view = view::project_scene(world, p, {});
  int lengthwise = 0;
  for (const edges::FeatureEdge& edge : edges_of(world, view).edges) {
    const mesh::MeshEdge& mesh_edge = world.models[0].mesh->edges[edge.mesh_edge];
    const Vec3 from = world.points[mesh_edge.vertex[0]], to = world.points[mesh_edge.vertex[1]];
    if (from.y != to.y) continue;
    const auto [least, most] = std::minmax(edge.t[0], edge.t[1]);
    EXPECT_NEAR(most - least, 0.15, 1e-12);
    EXPECT_NEAR(std::min(std::abs(least - 0.6), std::abs(least - 0.25)), 0, 1e-12) << "from either end";
    ++lengthwise;
  }
  EXPECT_EQ(lengthwise, 2);
}

}  // namespace
}  // namespace epura::test::find_edges_test
