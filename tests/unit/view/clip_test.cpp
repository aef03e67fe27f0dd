// SPDX-License-Identifier: Apache-2.0
#include "view/clip.hpp"

#include <gtest/gtest.h>

#include "errors.hpp"
#include "shapes.hpp"
#include "view/projected_scene.hpp"

namespace epura::test::clip_test {
namespace {

double area_of(const view::Clipper& clipper, const std::vector<std::array<int, 3>>& triangles) {
  double area = 0;
  for (const auto& [i, j, k] : triangles) {
    const view::Mapped &a = clipper.vertices[i], &b = clipper.vertices[j], &c = clipper.vertices[k];
    area += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
  }
  return area;
}

TEST(Clip, AnEdgeIsCutOnceWhoeverAsks) {
  view::Clipper clipper;
  clipper.vertices = {{0, 0, 0, 1}, {4, 0, 8, 1}, {0, 4, 0, 1}, {4, 4, 0, 1}};
  const int left = clipper.add_plane({-1, 0, 0, 1});  // x <= 1
  const std::vector<int> planes{left};
  const auto there = clipper.clip_edge(0, 1, planes);
  const auto back = clipper.clip_edge(1, 0, planes);
  ASSERT_TRUE(there && back);
  EXPECT_EQ(there->vertex, (std::array{0, 4}));
  EXPECT_EQ(back->vertex, (std::array{4, 0}));
  EXPECT_EQ(there->t, (std::array{0.0, 0.25}));
  EXPECT_EQ(back->t, (std::array{0.75, 1.0}));
  EXPECT_EQ(clipper.vertices[4].x, 1);
  EXPECT_EQ(clipper.vertices[4].z, 2);
  std::vector<std::array<int, 3>> pieces;
  clipper.clip_triangle({0, 1, 2}, planes, pieces);
  clipper.clip_triangle({1, 3, 2}, planes, pieces);
  // The square is cut along three edges; the first of them was cut before.
  EXPECT_EQ(clipper.vertices.size(), 7U);
  EXPECT_EQ(area_of(clipper, pieces), 4);
}

TEST(Clip, WhatIsOutsideIsGoneAndWhatIsInsideStays) {
  view::Clipper clipper;
  clipper.vertices = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
  const int all = clipper.add_plane({0, 0, 0, 1});
  const int none = clipper.add_plane({0, 0, 0, -1});
  const int touching = clipper.add_plane({1, 0, 0, 0});
  std::vector<std::array<int, 3>> pieces;
  clipper.clip_triangle({0, 1, 2}, std::array{none}, pieces);
  EXPECT_TRUE(pieces.empty());
  EXPECT_FALSE(clipper.clip_edge(0, 1, std::array{none}));
  clipper.clip_triangle({0, 1, 2}, std::array{all, touching}, pieces);
  EXPECT_EQ(pieces, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
  EXPECT_EQ(clipper.clip_edge(2, 1, std::array{all, touching})->vertex, (std::array{2, 1}));
  EXPECT_EQ(clipper.vertices.size(), 3U);
}

TEST(Clip, BothEndsOfAnEdgeCanBeCut) {
  view::Clipper clipper;
  clipper.vertices = {{-4, 0, 0, 1}, {12, 0, 0, 1}};
  const std::vector<int> planes{clipper.add_plane({1, 0, 0, 0}), clipper.add_plane({-1, 0, 0, 4})};
  const auto edge = clipper.clip_edge(0, 1, planes);
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->t, (std::array{0.25, 0.5}));
}

// Looking along +y from the origin onto the plane y = 1: the place of (x, y, z) is (x/y, z/y).
projection::Projection along_y() { return perspective({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}); }

TEST(ProjectedScene, TheNearPlaneCutsEdgesInSpace) {
  const world::World world = world_of(box({-1, 1, -1}, {1, 5, 1}));
  view::ProjectedScene view = view::project_scene(world, along_y(), {.near = 2.0, .far = {}});
  // From (-1, 1, -1) to (-1, 5, -1): y = 2 lies a quarter of the way in space.
  const auto edge = view::clip_edge(view, 0, 2);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->t[0], 0.25, 1e-15);
  EXPECT_EQ(edge->t[1], 1);
  EXPECT_NEAR(view.vertices[edge->vertex[0]].x / view.map.normalisation + view.middle.x / view.map.normalisation, -0.5,
              1e-12);
  EXPECT_FALSE(view::clip_edge(view, 0, 1)) << "this edge lies before the near plane";
  // 4 side faces lose their front, the front face is gone: 2 triangles of the back, 2 of each side.
  EXPECT_EQ(view.triangles.size(), 2U + 4 * 3);
}

TEST(ProjectedScene, NearAndFarAreDistancesInFrontOfTheEye) {
  const world::World world = world_of(box({-1, 1, -1}, {1, 5, 1}));
  view::ProjectedScene view = view::project_scene(world, along_y(), {.near = 2.0, .far = 4.0});
  const auto edge = view::clip_edge(view, 2, 0);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->t[0], 0.25, 1e-15);
  EXPECT_NEAR(edge->t[1], 0.75, 1e-15);
}

// The projection ends at y = 3 and y = 4.
TEST(ProjectedScene, NearAndFarDoNotWidenTheLimitsOfAProjection) {
  const world::World world = world_of(box({-1, 1, -1}, {1, 5, 1}));
  projection::Projection limited = along_y();
  limited.front = -2;
  limited.back = -3;
  view::ProjectedScene view = view::project_scene(world, limited, {.near = 2.0, .far = 4.5});
  const auto edge = view::clip_edge(view, 2, 0);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->t[0], 0.25, 1e-15);
  EXPECT_NEAR(edge->t[1], 0.5, 1e-15);
}

TEST(ProjectedScene, OfAParallelViewNearAndFarCountFromThePlane) {
  const world::World world = world_of(box({0, 0, 0}, {1, 1, 8}));
  view::ProjectedScene view = view::project_scene(world, from_above(), {.near = -6.0, .far = -2.0});
  const auto edge = view::clip_edge(view, 0, 4);
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->t, (std::array{0.25, 0.75}));
}

TEST(ProjectedScene, NothingBetweenNearAndFarIsWrongInput) {
  const world::World world = world_of(box({-1, 1, -1}, {1, 5, 1}));
  for (const double far : {2.0, 1.0})
    EXPECT_EQ(error_of([&] { view::project_scene(world, along_y(), {.near = 2.0, .far = far}); }).where(),
              "near and far");
}

TEST(ProjectedScene, NothingBeforeTheEyeIsWrongInput) {
  const world::World world = world_of(box({-1, -5, -1}, {1, -1, 1}));
  const Error error = error_of([&] { view::project_scene(world, along_y(), {}); });
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_TRUE(contains(error.what(), "in front of the viewer")) << error.what();
  EXPECT_FALSE(error.hint().empty());
}

TEST(ProjectedScene, AWindowCutsEdgesButLeavesTrianglesAMargin) {
  const world::World world = world_of(plate(-10, -10, 10, 10, 0));
  projection::Projection p = from_above();
  p.window = projection::Window{{-1, -2}, {3, 2}};
  view::ProjectedScene view = view::project_scene(world, p, {});
  EXPECT_TRUE(view.window_given);
  const int a = view::add_point(view, {-10, 0, 0});
  const int b = view::add_point(view, {10, 0, 0});
  const auto edge = view::clip_edge(view, a, b);
  ASSERT_TRUE(edge);
  EXPECT_NEAR(edge->t[0], 9.0 / 20, 1e-15);
  EXPECT_NEAR(edge->t[1], 13.0 / 20, 1e-15);
  double min = HUGE_VAL, max = -HUGE_VAL;
  for (const view::ViewTriangle& triangle : view.triangles)
    for (const int v : triangle.vertex) {
      min = std::min(min, view.vertices[v].x);
      max = std::max(max, view.vertices[v].x);
    }
  EXPECT_NEAR((max - min) / view.map.normalisation, 1.5 * 4, 1e-12);
  EXPECT_FALSE(view::clip_edge(view, 0, 1)) << "the plate's border lies outside";
}

TEST(ProjectedScene, RingsEndAtTheWindow) {
  const world::World world = world_of(plate(-10, -10, 10, 10, 0));
  const auto area_in = [&](const std::optional<projection::Window>& window) {
    projection::Projection p = from_above();
    p.window = window;
    view::ProjectedScene view = view::project_scene(world, p, {});
    const std::vector<int> ring = view::clip_ring(view, {0, 1, 2, 3});
    double area = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const view::PageVertex &a = view.vertices[ring[i]], &b = view.vertices[ring[(i + 1) % ring.size()]];
      area += (a.x * b.y - a.y * b.x) / 2;
    }
    const double unit = view.map.normalisation * view.map.unit;
    return std::abs(area) / (unit * unit);
  };
  EXPECT_NEAR(area_in(std::nullopt), 400, 1e-9);
  EXPECT_NEAR(area_in(projection::Window{{0, 0}, {20, 20}}), 100, 1e-9);
  EXPECT_NEAR(area_in(projection::Window{{-2, -30}, {3, 5}}), 75, 1e-9);
}

TEST(ProjectedScene, AnEyeInTheSceneGetsAConeOf120Degrees) {
  const view::ProjectedScene view = view::project_scene(world_of(box({-9, -9, -9}, {9, 9, 9})), along_y(), {});
  EXPECT_TRUE(view.window_given);
  // The plane is at distance 1: its half window is tan 60 degrees.
  EXPECT_NEAR((view.window.max.x - view.window.min.x) / view.map.normalisation, 2 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR((view.window.max.y - view.window.min.y) / view.map.normalisation, 2 * std::sqrt(3.0), 1e-12);
}

TEST(ProjectedScene, TheGridIsFineAndHoldsTheWindow) {
  for (const double size : {1e-300, 1e-6, 1.0, 3.0, 1e6, 1e300}) {
    const view::ProjectedScene view =
        view::project_scene(world_of(box({0, 0, 0}, {1, 0.5, 0.25}).scaled(size)), orthographic({1, -2, 3}), {});
    EXPECT_LT(view.cell, view.extent * 0x1p-28) << size;
    int max = 0;
    for (std::size_t v = 0; v < view.grid.size(); ++v) {
      max = std::max({max, std::abs(view.grid[v].x), std::abs(view.grid[v].y)});
      EXPECT_NEAR(view.grid[v].x, view.vertices[v].x / view.cell, 0.5) << size;
    }
    EXPECT_GT(max, 1 << 28) << size;
    EXPECT_LT(max, 1 << 30) << size;
  }
}

TEST(ProjectedScene, ContactIsFourCellsAndThatOfCommonCornersIsRounding) {
  world::World world = world_of(plate(-10, -10, 10, 10, 0));
  const view::Contact exact = view::project_scene(world, from_above(), {}).contact;
  EXPECT_EQ(exact.touching, 4 * view::project_scene(world, from_above(), {}).cell);
  EXPECT_EQ(exact.joined, std::ldexp(view::project_scene(world, from_above(), {}).extent, -44));
  world.rounding = 0.01;
  const view::ProjectedScene rounded = view::project_scene(world, from_above(), {});
  const double unit = rounded.map.normalisation * rounded.map.unit;
  EXPECT_EQ(rounded.contact.touching, 0.01 * unit);
  EXPECT_EQ(rounded.contact.joined, 0.01 * unit);
  // A length that was given bounds both.
  const view::Contact given = view::project_scene(world, from_above(), {.contact = 0.001}).contact;
  EXPECT_NEAR(given.touching, 0.001 * unit, 1e-15);
  EXPECT_EQ(given.joined, given.touching);
}

TEST(ProjectedScene, CrossIsExact) {
  const view::GridPoint a{-1073741823, -1073741823}, b{1073741823, 1073741822}, c{0, 0};
  // (2^31 - 2)(2^30 - 1) - (2^31 - 3)(2^30 - 1)
  EXPECT_EQ(view::cross(a, b, c), 1073741823);
  EXPECT_EQ(view::cross(b, a, c), -1073741823);
  EXPECT_EQ(view::cross(a, a, c), 0);
}

}  // namespace
}  // namespace epura::test::clip_test
