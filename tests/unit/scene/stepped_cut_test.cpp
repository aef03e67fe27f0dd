// SPDX-License-Identifier: Apache-2.0
// Cuts by parallel planes with steps between them: offset and half sections.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "errors.hpp"
#include "scene/cut_world.hpp"
#include "scene/cutting_surface.hpp"
#include "shapes.hpp"

namespace epura::test {
namespace {

constexpr double pi = std::numbers::pi;

scene::CuttingSurface surface(const std::vector<Vec3>& path, const Vec3& normal = {0, -1, 0}) {
  return scene::make_cutting_surface({{"A", "a.toml:3:1"}, Vec3(0), normal, {path, "a.toml:4:8"}});
}

scene::CutWorld cut(const scene::World& world, const std::vector<Vec3>& path) {
  return scene::cut_world(world, surface(path));
}

double area(const scene::World& world, int triangle) {
  const auto [a, b, c] = world.triangles[triangle];
  return glm::length(glm::cross(world.points[b] - world.points[a], world.points[c] - world.points[a])) / 2;
}

double cut_area(const scene::World& whole, const scene::CutWorld& cut) {
  double sum = 0;
  for (std::size_t m = 0; m < whole.models.size(); ++m) {
    const std::vector<int>& polygons = whole.models[m].mesh->polygon;
    const int last = *std::max_element(polygons.begin(), polygons.end());
    const mesh::Mesh& mesh = *cut.world.models[m].mesh;
    for (std::size_t t = 0; t < mesh.polygon.size(); ++t)
      if (mesh.polygon[t] > last) sum += area(cut.world, cut.world.first_triangle[m] + static_cast<int>(t));
  }
  return sum;
}

double surface_area(const scene::World& world) {
  double sum = 0;
  for (std::size_t t = 0; t < world.triangles.size(); ++t) sum += area(world, static_cast<int>(t));
  return sum;
}

double outline_length(const scene::CutWorld& cut) {
  double sum = 0;
  const mesh::Mesh& mesh = *cut.world.models[0].mesh;
  for (const mesh::MeshEdge& edge : mesh.edges)
    if (edge.cut == mesh::CutEdge::outline)
      sum += glm::distance(cut.world.points[edge.vertex[0]], cut.world.points[edge.vertex[1]]);
  return sum;
}

// A ring of square section about the z axis: inner radius 2, outer radius 3, height 1.
Shape ring(int around) {
  Shape shape;
  const std::array<std::array<double, 2>, 4> profile{{{3, 0}, {3, 1}, {2, 1}, {2, 0}}};
  for (const auto& [r, z] : profile)
    for (int k = 0; k < around; ++k) {
      const double a = 2 * pi * k / around;
      shape.points.push_back({r * std::cos(a), r * std::sin(a), z});
    }
  const auto place = [&](int i, int k) { return (i % 4) * around + k % around; };
  for (int i = 0; i < 4; ++i)
    for (int k = 0; k < around; ++k)
      shape.faces.push_back({place(i, k), place(i, k + 1), place(i + 1, k + 1), place(i + 1, k)});
  return shape;
}

// Boxes of depth 6 beside each other along x, joined to one body: heights 1, 2 and 3.
Shape stairs() {
  Shape shape;
  const std::vector<std::array<double, 2>> profile{{0, 0}, {4, 0}, {8, 0}, {12, 0}, {12, 3},
                                                   {8, 3}, {8, 2}, {4, 2}, {4, 1},  {0, 1}};
  const int n = static_cast<int>(profile.size());
  for (const double y : {0.0, 6.0})
    for (const auto& [x, z] : profile) shape.points.push_back({x, y, z});
  std::vector<int> front, back;
  for (int i = 0; i < n; ++i) {
    front.push_back(i);
    back.push_back(2 * n - 1 - i);
    shape.faces.push_back({(i + 1) % n, i, n + i, n + (i + 1) % n});
  }
  shape.faces.push_back(front);
  shape.faces.push_back(back);
  return shape;
}

TEST(SteppedCut, OfABoxHasTheAreaOfAPlaneCut) {
  const scene::World box_world = world_of(box({0, 0, 0}, {10, 6, 4}));
  const scene::CutWorld stepped = cut(box_world, {{0, 1, 0}, {3, 1, 0}, {3, 4, 0}, {10, 4, 0}});
  ASSERT_EQ(stepped.faces.size(), 1U);
  EXPECT_EQ(stepped.faces[0].rings.size(), 2U);
  EXPECT_TRUE(stepped.open.empty());
  EXPECT_DOUBLE_EQ(cut_area(box_world, stepped), 40);
  // Without the step: 3 x 5 and 7 x 2 remain, of top, bottom, back and sides.
  EXPECT_DOUBLE_EQ(surface_area(stepped.world), 40 + 2 * (3 * 5 + 7 * 2) + 40 + 4 * 5 + 4 * 2);
  EXPECT_DOUBLE_EQ(outline_length(stepped), 2 * 10 + 2 * 4);
}

TEST(SteppedCut, AreasOfStripsAddUp) {
  const scene::World world = world_of(stairs());
  // Steps within the blocks: each strip has its own heights.
  const scene::CutWorld stepped = cut(world, {{-1, 1, 0}, {2, 1, 0}, {2, 3, 0}, {5, 3, 0}, {5, 2, 0}, {20, 2, 0}});
  EXPECT_DOUBLE_EQ(cut_area(world, stepped), 4 * 1 + 4 * 2 + 4 * 3);
  // Steps where the heights change.
  const scene::CutWorld at_walls = cut(world, {{-1, 1, 0}, {4, 1, 0}, {4, 3, 0}, {8, 3, 0}, {8, 2, 0}, {20, 2, 0}});
  EXPECT_DOUBLE_EQ(cut_area(world, at_walls), 4 * 1 + 4 * 2 + 4 * 3);
  EXPECT_TRUE(at_walls.open.empty());
  EXPECT_NEAR(outline_length(at_walls), outline_length(stepped), 1e-12);
}

TEST(SteppedCut, OfBodiesHasAFaceForEach) {
  const scene::World world = world_of({box({0, 0, 0}, {4, 6, 4}), box({4, 0, 0}, {8, 6, 2})});
  const scene::CutWorld stepped = cut(world, {{0, 1, 0}, {2, 1, 0}, {2, 3, 0}, {8, 3, 0}});
  ASSERT_EQ(stepped.faces.size(), 2U);
  EXPECT_EQ(stepped.faces[0].rings.size(), 2U);
  EXPECT_EQ(stepped.faces[1].rings.size(), 1U);
  EXPECT_DOUBLE_EQ(cut_area(world, stepped), 16 + 8);
}

TEST(SteppedCut, AHalfSectionOfARingHasHalfTheArea) {
  for (const int around : {32, 33}) {
    const scene::World world = world_of(ring(around));
    const scene::CutWorld whole = cut(world, {{-5, 0, 0}, {5, 0, 0}});
    const scene::CutWorld half = cut(world, {{0, -5, 0}, {0, 0, 0}, {5, 0, 0}});
    const scene::CutWorld other = cut(world, {{-5, 0, 0}, {0, 0, 0}, {0, -5, 0}});
    EXPECT_NEAR(cut_area(world, half) + cut_area(world, other), cut_area(world, whole), 1e-12);
    if (around == 32) {
      EXPECT_NEAR(cut_area(world, half), 1, 1e-12);
    }
    // Three quarters of the ring remain, and one of two cut faces.
    const double surface = surface_area(world);
    EXPECT_NEAR(surface_area(half.world) - cut_area(world, half) + surface_area(other.world) - cut_area(world, other),
                surface + (surface_area(whole.world) - cut_area(world, whole)), 1e-11);
  }
}

TEST(SteppedCut, KeepsTheEdgesOfTheFile) {
  const scene::World world = world_of(box({0, 0, 0}, {10, 6, 4}));
  const scene::CutWorld stepped = cut(world, {{0, 1, 0}, {3, 1, 0}, {3, 4, 0}, {10, 4, 0}});
  const mesh::Mesh& mesh = *stepped.world.models[0].mesh;
  ASSERT_EQ(mesh.uncut, world.models[0].mesh);
  double length = 0;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    if (edge.cut != mesh::CutEdge::none) continue;
    const mesh::EdgeOrigin origin = mesh.origin_of(edge);
    ASSERT_TRUE(origin.in_file);
    const Vec3 p = world.points[origin.vertex[0]], q = world.points[origin.vertex[1]];
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_LT(glm::distance(stepped.world.points[edge.vertex[i]], p + origin.t[i] * (q - p)), 1e-14);
    if (!world.models[0].mesh->edge_between(origin.vertex)->diagonal)
      length += glm::distance(stepped.world.points[edge.vertex[0]], stepped.world.points[edge.vertex[1]]);
  }
  EXPECT_DOUBLE_EQ(length, 2 * 10 + 2 * 4 + 2 * 5 + 2 * 2);
}

TEST(SteppedCut, StraightPathsArePlanes) {
  const scene::CuttingSurface straight = surface({{0, 1, 0}, {3, 1, 0}, {7, 1, 0}});
  EXPECT_TRUE(straight.is_plane());
}

TEST(SteppedCut, MayLeaveCutFacesOnly) {
  const scene::World world = world_of(ring(32));
  for (const std::vector<Vec3>& path :
       {std::vector<Vec3>{{-5, 0, 0}, {5, 0, 0}}, std::vector<Vec3>{{-5, 0, 0}, {0, 0, 0}, {0, -5, 0}}}) {
    scene::CuttingSurface section = surface(path);
    section.beyond = false;
    const scene::CutWorld faces = scene::cut_world(world, section);
    EXPECT_NEAR(surface_area(faces.world), path.size() == 2 ? 2 : 1, 1e-12);
    EXPECT_NEAR(outline_length(faces), path.size() == 2 ? 8 : 4, 1e-12);
  }
}

TEST(SteppedCut, RefusesPathsThatAreNone) {
  const auto refused = [](const std::vector<Vec3>& path, const std::string& why) {
    const std::string what = error_of([&] { surface(path); }).what();
    EXPECT_TRUE(contains(what, why)) << what;
    EXPECT_TRUE(contains(what, "a.toml:4:8")) << what;
  };
  refused({{0, 0, 0}}, "fewer than two points");
  refused({{0, 0, 0}, {0, 0, 0}}, "are the same");
  refused({{0, 0, 0}, {0, -1, 0}}, "runs along the normal");
  refused({{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}, "goes back on itself at point 2");
  refused({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {4, 1, 0}, {6, 1, 0}}, "goes back on itself at point 3");
  refused({{0, 0, 0}, {4, 1, 0}}, "is inclined after point 1");
  refused({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {6, 3, 1}}, "point 4 of the path is not in a plane");
  refused({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}}, "ends with a step against the normal");
  refused({{0, 0, 0}, {4, 0, 0}, {4, 0, 0}}, "point 3 of the path is the same");
  refused({{0, 0, 0}, {NAN, 0, 0}}, "not finite");
}

TEST(SteppedCut, RefusesSurfacesThatMiss) {
  const scene::World world = world_of(box({0, 0, 0}, {10, 6, 4}));
  const auto refused = [&](double first, double second, const std::string& why) {
    const std::vector<Vec3> path{{0, first, 0}, {5, first, 0}, {5, second, 0}, {9, second, 0}};
    const std::string what = error_of([&] { cut(world, path); }).what();
    EXPECT_TRUE(contains(what, why)) << what;
  };
  refused(7, 8, "removes everything");
  refused(-7, -8, "cuts nothing");
}

}  // namespace
}  // namespace epura::test
