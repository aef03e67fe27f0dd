// SPDX-License-Identifier: Apache-2.0
#include "visibility/occlusion_query.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <utility>

#include "shapes.hpp"

namespace epura::test::occlusion_query_test {
namespace {

// Unit plates, each a millionth to the right, behind and below the last.
world::World stack(int plates) {
  Shape shape;
  for (int i = 0; i < plates; ++i) {
    const double shift = 1e-6 * i;
    shape.add(plate(shift, shift, 1 + shift, 1 + shift, -shift));
  }
  return world_of(shape);
}

double tries_of_an_edge(const world::World& world, const projection::Projection& projection) {
  const Result r = draw(world, projection);
  const visibility::OccluderGrid occluders(r.world, r.view, r.drawn.edges);
  long tries = 0;
  for (const edges::FeatureEdge& edge : r.drawn.edges) {
    const visibility::PageEdge line{edge.vertex[0], edge.vertex[1]};
    visibility::OcclusionQuery hider(r.view, occluders, line, visibility::OwnTriangles(r.world, r.drawn, edge));
    occluders.along(line, [&](const visibility::CellSegment& stretch) { hider.hide(stretch); });
    tries += hider.tries();
  }
  return static_cast<double>(tries) / static_cast<double>(r.drawn.edges.size());
}

// What lies partly in front of the cover of a cell may be seen.
TEST(OcclusionQuery, CoversHideWhatIsWhollyBehindThem) {
  const Result r = draw(world_of(box({0, 0, 0}, {1, 2, 3})), orthographic({1, 2, 3}, {0, 0, 1}));
  const visibility::OccluderGrid occluders(r.world, r.view, r.drawn.edges);
  int slanted = 0;
  for (const edges::FeatureEdge& edge : r.drawn.edges) {
    const visibility::PageEdge line{edge.vertex[0], edge.vertex[1]};
    const auto [farthest, nearest] = occluders.depths(line, 0, 1);
    if (!(farthest < nearest)) continue;
    ++slanted;
    const auto hidden_by = [&](double cover) {
      visibility::OcclusionQuery query(r.view, occluders, line, visibility::OwnTriangles(r.world, r.drawn, edge));
      query.hide({0, 1, cover, {}, nullptr});
      return std::move(query).spans();
    };
    EXPECT_TRUE(hidden_by((farthest + nearest) / 2).empty());
    EXPECT_EQ(hidden_by(nearest + 1), (visibility::Spans{{0, 1}}));
  }
  EXPECT_GT(slanted, 0);
}

// Before half of the 2 * 4000 triangles lies the average edge.
TEST(OcclusionQuery, TriesFewTrianglesOfAStackWhereverItIsSeenFrom) {
  const world::World world = stack(4000);
  for (const Vec3& towards_viewer : {Vec3(1, -1, 1), Vec3(1, 1, 1), Vec3(0.3, -0.8, 0.5), Vec3(0, 0, 1)})
    EXPECT_LT(tries_of_an_edge(world, orthographic(towards_viewer, {0, 1, 0.1})), 100);
}

// Of half of the plates, a side that falls on theirs is visible: each would be tried on all before it.
TEST(OcclusionQuery, TriesFewTrianglesOfEqualPartsBehindOneAnother) {
  Shape plates;
  std::vector<Shape> copies;
  for (int i = 0; i < 1000; ++i) {
    plates.add(box({0, 0, 0.5 * i}, {100, 60, 0.5 * i + 0.3}));
    copies.push_back(box({0, 0, 0}, {1, 2, 3}));
  }
  copies.resize(300);
  EXPECT_LT(tries_of_an_edge(world_of(plates), from_above()), 20);
  for (const Vec3& towards_viewer : {Vec3(1, -1, 1), Vec3(0.3, -0.8, 0.5), Vec3(0, 0, 1)})
    EXPECT_LT(tries_of_an_edge(world_of(copies), orthographic(towards_viewer, {0, 1, 0.1})), 50);
  EXPECT_LT(tries_of_an_edge(world_of(copies), perspective({3, -2, 9}, {0, 0, 0}, {3, -2, 9}, {0, 0, 1})), 50);
}

// How often the search for occluders asks for the time: once for each piece or triangle of each cell that is divided.
long steps_of_grid(const world::World& world) {
  const Result r = draw(world, from_above());
  std::atomic<long> steps = 0;
  ProgressBoard board([&] { return static_cast<double>(0 * ++steps); });
  const visibility::OccluderGrid occluders(r.world, r.view, r.drawn.edges, visibility::Covers::any, Progress(board, 1));
  return steps;
}

// However small cells are, nearly all of them are in each.
TEST(OcclusionQuery, CellsOfCopiesSideBySideAreNotDividedWithoutEnd) {
  const auto copies = [](int count) {
    Shape shape;
    for (int i = 0; i < count; ++i) shape.add(box({1e-9 * i, 0, 0}, {1 + 1e-9 * i, 1, 1}));
    return world_of(shape);
  };
  EXPECT_LT(steps_of_grid(copies(1400)), 4 * steps_of_grid(copies(700)));
}

constexpr int many = 4000;

// At the hub all of them meet.
TEST(OcclusionQuery, TriesFewNeedlesOfOneHub) {
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0 - 0.5; };
  Shape burst{{{0, 0, 0}}, {}, {}};
  for (int i = 0; i < many; ++i) {
    const double x = number(), y = number(), z = number();
    burst.points.insert(burst.points.end(), {{x, y, z}, {x + 1e-5, y, z}});
    burst.faces.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  EXPECT_LT(tries_of_an_edge(world_of(burst), orthographic({1, -1, 1})), many / 16);
}

TEST(OcclusionQuery, TriesFewTrianglesOnOneLine) {
  Shape line{{{0, 0, 0}, {100, 0, 0}, {50, 50, 0}, {1, 0, 0}}, {{0, 1, 2}}, {}};
  for (int i = 1; i <= many; ++i) {
    line.points.push_back({1 + 99.0 * i / many, 0, 0});
    line.faces.push_back({0, i + 2, i + 3});
  }
  EXPECT_LT(tries_of_an_edge(world_of(line), orthographic({1, -1, 1})), many / 64);
}

TEST(OcclusionQuery, TriesFewTrianglesOfOnePlane) {
  std::mt19937 random(1);
  const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
  Shape across;
  for (int i = 0; i < many / 4; ++i) {
    const double from = number(), to = number();
    across.points.insert(across.points.end(), {{0, from, 0}, {1, to, 0}, {1, to + 1e-4, 0}});
    across.faces.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_LT(tries_of_an_edge(world_of(across), orthographic({1, -1, 1})), many / 32);
}

TEST(OcclusionQuery, HasNoMoreCandidatesOfManyCopiesThanOfTwo) {
  const auto max_candidates = [](int copies) {
    const world::World world =
        world_of(std::vector<Shape>(static_cast<std::size_t>(copies), box({0, 0, 0}, {1, 2, 3})));
    const Result r = draw(world, orthographic({0.3, -0.8, 0.5}));
    const visibility::OccluderGrid occluders(r.world, r.view, r.drawn.edges);
    std::size_t max = 0;
    for (const edges::FeatureEdge& edge : r.drawn.edges)
      occluders.along({edge.vertex[0], edge.vertex[1]},
                      [&](const visibility::CellSegment& stretch) { max = std::max(max, stretch.candidates.size()); });
    return max;
  };
  EXPECT_GT(max_candidates(2), 0);
  EXPECT_LE(max_candidates(300), 2 * 12);
}

}  // namespace
}  // namespace epura::test::occlusion_query_test
