// SPDX-License-Identifier: Apache-2.0
#include "edges/intersections.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "edges/crossing_candidates.hpp"
#include "edges/limits.hpp"
#include "refine/refine_world.hpp"
#include "shapes.hpp"

namespace epura::test::intersections_test {
namespace {

// An upright triangle, which crosses z = 0 from x = 0 to 0.5, and a level one that begins at x = `begin`.
std::vector<edges::FaceCrossing> crossings(double begin, double contact) {
  const Shape upright{{{0, 0, -1}, {0, 0, 1}, {1, 0, 1}}, {{0, 1, 2}}, {}};
  const Shape level{{{begin, -1, 0}, {begin, 1, 0}, {3, 0, 0}}, {{0, 1, 2}}, {}};
  const world::World world = world_of(std::vector<Shape>{upright, level});
  return edges::find_intersections(world, 1, contact, edges::all_triangles(world)).found;
}

TEST(Intersections, AreLongerThanContact) {
  constexpr double contact = 0.01;
  const auto found = crossings(0.4, contact);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(glm::distance(found[0].ends[0], found[0].ends[1]), 0.1, 1e-12);
  EXPECT_NEAR(found[0].angle, 90, 1e-9);
  EXPECT_EQ(crossings(0.48, contact).size(), 1U);
  EXPECT_TRUE(crossings(0.495, contact).empty());
  EXPECT_TRUE(crossings(0.4999, contact).empty());
  EXPECT_EQ(crossings(0.495, 1e-6).size(), 1U);
}

std::vector<edges::FaceCrossing> crossings_of(const std::vector<Shape>& shapes, double contact) {
  const world::World world = world_of(shapes);
  return edges::find_intersections(world, 1, contact, edges::all_triangles(world)).found;
}

const Shape level_plate{{{-2, -2, 0}, {4, -2, 0}, {-2, 4, 0}}, {{0, 1, 2}}, {}};

// Two triangles of one edge, of which one stands on the plate and the other hangs below it.
TEST(Intersections, OfAnEdgeInAPlaneAreWhereTheSurfaceGoesOn) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0.5, -1}};
  const auto through = crossings_of({Shape{points, {{0, 1, 2}, {1, 0, 3}}, {}}, level_plate}, 1e-3);
  ASSERT_EQ(through.size(), 1U);
  EXPECT_NEAR(glm::distance(through[0].ends[0], through[0].ends[1]), 1, 1e-15);
  EXPECT_TRUE(crossings_of({Shape{points, {{0, 1, 2}}, {}}, level_plate}, 1e-3).empty());
}

// A corner within contact of a plane is in it: the line ends there.
TEST(Intersections, EndAtCornersThatTouch) {
  const double contact = 0.01;
  const Shape upright{{{0, 0, -1}, {0, 0, 1}, {1, 0, contact / 2}}, {{0, 1, 2}}, {}};
  const auto found = crossings_of({upright, level_plate}, contact);
  ASSERT_EQ(found.size(), 1U);
  std::array<Vec3, 2> ends = found[0].ends;
  if (ends[0].x > ends[1].x) std::swap(ends[0], ends[1]);
  EXPECT_LT(glm::distance(ends[0], Vec3(0, 0, 0)), 1e-15);
  EXPECT_LT(glm::distance(ends[1], Vec3(1, 0, contact / 2)), 1e-15);
}

TEST(Intersections, HaveNoTrianglesLowerThanContact) {
  const auto is_low = [](double height) { return edges::is_low(Vec3(0), Vec3(2, 0, 0), Vec3(1, height, 0), 0.25); };
  EXPECT_TRUE(is_low(0));
  EXPECT_TRUE(is_low(0.25));
  EXPECT_FALSE(is_low(0.26));
}

// Two nearly level triangles, 0.12 apart: each has a corner within contact of the plane of the other, far from the line
// in which the planes meet.
TEST(Intersections, LieInBothTriangles) {
  const Shape one{{{1.58, 0.78, 0.011}, {3.26, 2.91, -0.002}, {2.32, 1.33, 0.021}}, {{0, 1, 2}}, {}};
  const Shape two{{{1.88, 0.33, 0.092}, {2.06, 0.9, 0.042}, {4.49, 2.71, -0.08}}, {{0, 1, 2}}, {}};
  EXPECT_TRUE(crossings_of({one, two}, 0.02).empty());
}

// Upright triangles in two directions, of which each crosses all of the other direction.
edges::FaceCrossings crossings_of_lattice(int lines) {
  Shape lattice;
  const auto add = [&](const std::array<Point, 3>& corners) {
    const int first = static_cast<int>(lattice.points.size());
    lattice.points.insert(lattice.points.end(), corners.begin(), corners.end());
    lattice.faces.push_back({first, first + 1, first + 2});
  };
  for (int i = 0; i < lines; ++i) {
    const double at = static_cast<double>(i) / lines;
    add({Point{at, -1, -1}, Point{at, 2, -1}, Point{at, 0.5, 2}});
    add({Point{-1, at, -1}, Point{2, at, -1}, Point{0.5, at, 2}});
  }
  const world::World world = world_of({lattice});
  return edges::find_intersections(world, 0.25, 1e-9, edges::all_triangles(world));
}

TEST(Intersections, EndWhereThereAreTooMany) {
  const edges::FaceCrossings all = crossings_of_lattice(400);
  EXPECT_EQ(all.found.size(), 400U * 400);
  EXPECT_EQ(all.searched, 1);
  EXPECT_FALSE(all.too_many);
  const edges::FaceCrossings some = crossings_of_lattice(1800);
  EXPECT_TRUE(some.too_many);
  EXPECT_LT(some.searched, 1);
  EXPECT_GT(some.found.size(), edges::most_crossings);
  EXPECT_LT(some.found.size(), 1.2 * edges::most_crossings);
  const ThreadLimit one(1);
  EXPECT_TRUE(std::ranges::equal(crossings_of_lattice(1800).found, some.found,
                                 [](const auto& a, const auto& b) { return a.triangles == b.triangles; }));
}

// Intersections that one view has found are those of another, but where one of them splits triangles.
TEST(Intersections, OfRefinedViewsAreShared) {
  Shape across = revolved({{0, -20}, {7, -20}, {7, 20}, {0, 20}}, 17);
  for (auto& p : across.points) p = {p[2], p[0], p[1] + 20};
  const world::World world =
      recognised(world_of(std::vector<Shape>{revolved({{0, 0}, {10, 0}, {10, 40}, {0, 40}}, 24), across}));
  const double normalisation = 1.0 / 64, contact = 1e-9;
  std::optional<edges::KnownCrossings> known;  // by triangles that are not split
  for (const double turn : {0.3, 1.1, 2.7}) {
    const auto refined = refine::refine_world(world, orthographic({std::sin(turn), -std::cos(turn), 0.7}));
    ASSERT_TRUE(refined) << turn;
    edges::CrossingCandidates candidates = edges::crossing_candidates(*refined, normalisation, contact);
    const std::vector<edges::FaceCrossing> all =
        edges::find_intersections(*refined, normalisation, contact, candidates).found;
    ASSERT_GT(all.size(), 20U);
    if (known) {
      std::vector<int> numbers(world.triangles.size(), -1);
      for (std::size_t t = 0; t < refined->kept.size(); ++t)
        if (refined->kept[t] >= 0) numbers[refined->kept[t]] = static_cast<int>(t);
      candidates.known = edges::renumbered(*known, numbers, refined->triangles.size());
      EXPECT_GT(candidates.known.found.size(), 10U) << turn;
      EXPECT_LT(candidates.known.found.size(), all.size()) << turn;
      EXPECT_EQ(edges::find_intersections(*refined, normalisation, contact, candidates).found, all) << turn;
    }
    known = edges::renumbered({all, std::vector<char>(refined->triangles.size(), 1)}, refined->kept,
                              world.triangles.size());
  }
}

TEST(Intersections, AreFoundOnceWhicheverAreSettled) {
  Shape across = revolved({{0, -20}, {7, -20}, {7, 20}, {0, 20}}, 17);
  for (auto& p : across.points) p = {p[2], p[0], p[1] + 20};
  const world::World world = world_of(std::vector<Shape>{revolved({{0, 0}, {10, 0}, {10, 40}, {0, 40}}, 24), across});
  edges::CrossingCandidates candidates = edges::all_triangles(world);
  const std::vector<edges::FaceCrossing> all = edges::find_intersections(world, 1.0 / 64, 1e-9, candidates).found;
  for (std::size_t every = 2; every < 12; ++every) {
    std::vector<char>& is_settled = candidates.known.is_settled;
    is_settled.assign(world.triangles.size(), 1);
    for (std::size_t t = 0; t < is_settled.size(); t += every) is_settled[t] = 0;
    candidates.known.found = all;
    std::erase_if(candidates.known.found, [&](const edges::FaceCrossing& crossing) {
      return std::ranges::any_of(crossing.triangles, [&](int t) { return is_settled[t] == 0; });
    });
    EXPECT_EQ(edges::find_intersections(world, 1.0 / 64, 1e-9, candidates).found, all) << every;
  }
}

}  // namespace
}  // namespace epura::test::intersections_test
