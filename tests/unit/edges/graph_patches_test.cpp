// SPDX-License-Identifier: Apache-2.0
#include "edges/graph_patches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <set>

#include "edges/crossing_candidates.hpp"
#include "edges/find_edges.hpp"
#include "edges/intersections.hpp"
#include "shapes.hpp"

namespace epura::test::graph_patches_test {
namespace {

constexpr double contact = 1e-9;

/// A surface over a rectangle of u and v, as a grid of `cells` by `cells` with two triangles each, where `is_there`.
Shape surface(
    int cells, const std::function<Vec3(double, double)>& place,
    const std::function<bool(int, int)>& is_there = [](int, int) { return true; }) {
  Shape shape;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j) {
      const Vec3 p = place(static_cast<double>(i) / cells, static_cast<double>(j) / cells);
      shape.points.push_back({p.x, p.y, p.z});
    }
  const auto at = [cells](int i, int j) { return i * (cells + 1) + j; };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      if (!is_there(i, j)) continue;
      shape.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      shape.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return shape;
}

Vec3 hill(double u, double v) { return {u, v, 0.1 * std::sin(5 * u) * std::cos(7 * v)}; }

std::vector<int> patches_of(const Shape& shape, const std::vector<int>& taken = {}) {
  const world::World world = world_of(shape);
  return edges::graph_patches(world, edges::normalised_points(world, 1), contact, edges::all_triangles(world).triangles,
                              taken);
}

std::size_t count_of(const std::vector<int>& patches) {
  std::set<int> numbers(patches.begin(), patches.end());
  numbers.erase(-1);
  return numbers.size();
}

TEST(GraphPatches, AreHills) { EXPECT_EQ(patches_of(surface(40, hill)), std::vector<int>(3200, 0)); }

TEST(GraphPatches, MayFaceAnySide) {
  const auto turned = [](int axis, bool down) {
    return surface(40, [=](double u, double v) {
      const Vec3 p = down ? hill(v, u) : hill(u, v);
      return axis == 0 ? Vec3(p.z, p.x, p.y) : axis == 1 ? Vec3(p.y, p.z, p.x) : p;
    });
  };
  for (const int axis : {0, 1, 2})
    for (const bool down : {false, true})
      EXPECT_EQ(patches_of(turned(axis, down)), std::vector<int>(3200, 0)) << axis << down;
}

TEST(GraphPatches, MayHaveHolesThatTouchInCorners) {
  const auto hole = [](int i, int j) { return i / 5 == 3 && j / 5 == 3; };
  const auto touching = [&](int i, int j) { return hole(i, j) || hole(i + 5, j + 5) || hole(i + 5, j - 5); };
  EXPECT_EQ(count_of(patches_of(surface(40, hill, [&](int i, int j) { return !hole(i, j); }))), 1U);
  EXPECT_EQ(count_of(patches_of(surface(40, hill, [&](int i, int j) { return !touching(i, j); }))), 1U);
}

TEST(GraphPatches, LeaveTakenTrianglesOut) {
  std::vector<int> taken(3200, -1);
  std::fill(taken.begin(), taken.begin() + 80, 0);  // a row at the border
  const std::vector<int> patches = patches_of(surface(40, hill), taken);
  EXPECT_EQ(std::count(patches.begin(), patches.end(), -1), 80);
}

TEST(GraphPatches, AreNotSmall) { EXPECT_TRUE(patches_of(surface(10, hill)).empty()); }

// Its boundary crosses itself: the ramp lies over itself.
TEST(GraphPatches, AreNoRampsOfMoreThanATurn) {
  const auto ramp = [](double turns, double outwards) {
    return surface(60, [=](double u, double v) {
      const double angle = -2 * M_PI * turns * u, radius = 0.4 + 0.3 * v + outwards * u;
      return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.2 * u);
    });
  };
  EXPECT_EQ(count_of(patches_of(ramp(0.9, 0))), 1U);
  EXPECT_EQ(count_of(patches_of(ramp(1.5, 0))), 0U);
  EXPECT_EQ(count_of(patches_of(ramp(1.5, 0.2))), 0U);
  EXPECT_EQ(count_of(patches_of(ramp(1.5, 1))), 1U);  // beside itself
}

// Around its middle it runs twice, so that it must pass through itself.
TEST(GraphPatches, AreNoSurfacesThatRunTwiceAroundAPoint) {
  const Shape twice = surface(60, [](double u, double v) {
    const double angle = -4 * M_PI * u, radius = 0.1 + 0.8 * v;
    return Vec3(radius * std::cos(angle), radius * std::sin(angle), 0.2 * v * std::sin(angle / 2));
  });
  EXPECT_EQ(count_of(patches_of(twice)), 0U);
}

// A square and a smaller one over it, crosswise connected along a slit: their outlines are apart, and both are
// counterclockwise.
TEST(GraphPatches, AreNotTwoSheetsAroundTwoPoints) {
  constexpr int cells = 60, slit = 30, first = 25, last = 35;
  Shape shape;
  std::map<std::array<int, 3>, int> vertices;  // i, j, and 0 or 1: which of the vertices there
  const auto vertex = [&](int i, int j, int which, double z) {
    const auto [found, is_new] = vertices.emplace(std::array{i, j, which}, static_cast<int>(shape.points.size()));
    if (is_new) shape.points.push_back({static_cast<double>(i) / cells, static_cast<double>(j) / cells, z});
    return found->second;
  };
  const auto corner = [&](bool small, bool above, int i, int j) {
    if (j != slit || i < first || i > last) return vertex(i, j, small ? 1 : 0, small ? 0.01 : 0);
    if (i == first || i == last) return vertex(i, j, 0, 0.005);
    return small == above ? vertex(i, j, 1, 0.006) : vertex(i, j, 0, 0.005);
  };
  for (const bool small : {false, true})
    for (int i = small ? 15 : 0; i < (small ? 45 : cells); ++i)
      for (int j = small ? 15 : 0; j < (small ? 45 : cells); ++j) {
        const auto at = [&](int di, int dj) { return corner(small, j >= slit, i + di, j + dj); };
        shape.faces.push_back({at(0, 0), at(1, 0), at(1, 1)});
        shape.faces.push_back({at(0, 0), at(1, 1), at(0, 1)});
      }
  EXPECT_EQ(count_of(patches_of(shape)), 0U);
}

TEST(GraphPatches, AreApartFromThemselves) {
  // A slot as narrow as the contact distance.
  const auto slotted = [](double width) {
    return surface(
        40, [=](double u, double v) { return hill(u < 0.5 ? u : u - 0.025 + width, v); },
        [](int i, int j) { return i != 20 || j > 20; });
  };
  EXPECT_EQ(count_of(patches_of(slotted(2 * contact))), 1U);
  EXPECT_EQ(count_of(patches_of(slotted(contact / 2))), 0U);
}

void expect_same_crossings(const world::World& world, double normalisation, const std::string& what) {
  const auto all = edges::find_intersections(world, normalisation, contact, edges::all_triangles(world));
  const auto some = edges::find_intersections(world, normalisation, contact,
                                              edges::crossing_candidates(world, normalisation, contact));
  ASSERT_EQ(all.found.size(), some.found.size()) << what;
  for (std::size_t i = 0; i < all.found.size(); ++i) {
    EXPECT_EQ(all.found[i].triangles, some.found[i].triangles) << what;
    EXPECT_EQ(all.found[i].ends, some.found[i].ends) << what;
  }
}

TEST(GraphPatches, ChangeNoCrossings) {
  expect_same_crossings(world_of(klein_bottle(120, 60)), 1, "klein bottle");
  expect_same_crossings(world_of(uv_sphere(120, 80)), 0x1p-1, "sphere");
  expect_same_crossings(world_of({surface(60, hill), surface(60, hill).moved(0.31, 0.17, 0.01)}), 0x1p-1, "two hills");
  // Waves that grow until they pass through each other.
  for (const double height : {0.05, 0.2, 0.5, 1.0}) {
    const Shape waves = surface(80, [=](double u, double v) {
      const double wave = height * std::sin(30 * u) * std::sin(20 * v);
      return Vec3(u + wave * std::cos(9 * u), v, wave);
    });
    expect_same_crossings(world_of(waves), 0x1p-1, "waves of " + std::to_string(height));
  }
}

TEST(GraphPatches, ChangeNoCrossingsOfNoise) {
  std::mt19937 random(7);
  for (int round = 0; round < 12; ++round) {
    const double noise = std::ldexp(1.0, -round);
    std::uniform_real_distribution<double> step(-noise / 30, noise / 30);
    Shape shape = surface(60, [](double u, double v) {
      return Vec3(std::cos(6 * u) * (1 + 0.3 * std::cos(6 * v)), std::sin(6 * u) * (1 + 0.3 * std::cos(6 * v)),
                  0.3 * std::sin(6 * v));
    });
    for (auto& point : shape.points)
      for (double& coordinate : point) coordinate += step(random);
    expect_same_crossings(world_of(shape), 0x1p-1, "noise " + std::to_string(round));
  }
}

TEST(FeatureEdges, AreTheSameWithKnownIntersections) {
  const world::World world = world_of({surface(20, hill), surface(20, hill).moved(0.31, 0.17, 0.01)});
  view::ProjectedScene one = view::project_scene(world, orthographic({1.1, -2, 1.3}), {}), other = one;
  const edges::FeatureEdges found = edges::find_feature_edges(world, one, {});
  const edges::FeatureEdges again = edges::find_feature_edges(world, other, {}, edges::intersections_of(found));
  ASSERT_FALSE(found.crossings.empty());
  ASSERT_EQ(found.edges.size(), again.edges.size());
  for (std::size_t i = 0; i < found.edges.size(); ++i) EXPECT_EQ(found.edges[i].vertex, again.edges[i].vertex);
}

}  // namespace
}  // namespace epura::test::graph_patches_test
