// SPDX-License-Identifier: Apache-2.0
// Cuts by parallel planes with steps between them: offset and half sections; and by planes that meet at an angle:
// aligned sections.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cut/cut_world.hpp"
#include "cut/cutting_surface.hpp"
#include "errors.hpp"
#include "shapes.hpp"

namespace epura::test::stepped_cut_test {
namespace {

constexpr double pi = std::numbers::pi;

cut::CuttingSurface surface(const std::vector<Vec3>& path, const Vec3& normal = {0, -1, 0}) {
  return cut::make_cutting_surface({{"A", "a.toml:3:1"}, Vec3(0), normal, {path, "a.toml:4:8"}});
}

cut::CutWorld cut(const world::World& world, const std::vector<Vec3>& path) {
  return cut::cut_world(world, surface(path));
}

double area(const world::World& world, int triangle) {
  const auto [a, b, c] = world.triangles[triangle];
  return glm::length(glm::cross(world.points[b] - world.points[a], world.points[c] - world.points[a])) / 2;
}

double cut_area(const world::World& whole, const cut::CutWorld& cut) {
  double sum = 0;
  for (std::size_t m = 0; m < cut.world.models.size(); ++m) {
    const auto number = static_cast<std::size_t>(cut.world.number_in_scene(static_cast<int>(m)));
    const std::vector<int>& polygons = whole.models[number].mesh->polygon;
    const int last = *std::max_element(polygons.begin(), polygons.end());
    const mesh::Mesh& mesh = *cut.world.models[m].mesh;
    for (std::size_t t = 0; t < mesh.polygon.size(); ++t)
      if (mesh.polygon[t] > last) sum += area(cut.world, cut.world.first_triangle[m] + static_cast<int>(t));
  }
  return sum;
}

double surface_area(const world::World& world) {
  double sum = 0;
  for (std::size_t t = 0; t < world.triangles.size(); ++t) sum += area(world, static_cast<int>(t));
  return sum;
}

double outline_length(const cut::CutWorld& cut) {
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
  const world::World box_world = world_of(box({0, 0, 0}, {10, 6, 4}));
  const cut::CutWorld stepped = cut(box_world, {{0, 1, 0}, {3, 1, 0}, {3, 4, 0}, {10, 4, 0}});
  ASSERT_EQ(stepped.faces.size(), 1U);
  EXPECT_EQ(stepped.faces[0].rings.size(), 2U);
  EXPECT_TRUE(stepped.open.empty());
  EXPECT_DOUBLE_EQ(cut_area(box_world, stepped), 40);
  // Without the step: 3 x 5 and 7 x 2 remain, of top, bottom, back and sides.
  EXPECT_DOUBLE_EQ(surface_area(stepped.world), 40 + 2 * (3 * 5 + 7 * 2) + 40 + 4 * 5 + 4 * 2);
  EXPECT_DOUBLE_EQ(outline_length(stepped), 2 * 10 + 2 * 4);
}

TEST(SteppedCut, AreasOfStripsAddUp) {
  const world::World world = world_of(stairs());
  // Steps within the blocks: each strip has its own heights.
  const cut::CutWorld stepped = cut(world, {{-1, 1, 0}, {2, 1, 0}, {2, 3, 0}, {5, 3, 0}, {5, 2, 0}, {20, 2, 0}});
  EXPECT_DOUBLE_EQ(cut_area(world, stepped), 4 * 1 + 4 * 2 + 4 * 3);
  // Steps where the heights change.
  const cut::CutWorld at_walls = cut(world, {{-1, 1, 0}, {4, 1, 0}, {4, 3, 0}, {8, 3, 0}, {8, 2, 0}, {20, 2, 0}});
  EXPECT_DOUBLE_EQ(cut_area(world, at_walls), 4 * 1 + 4 * 2 + 4 * 3);
  EXPECT_TRUE(at_walls.open.empty());
  EXPECT_NEAR(outline_length(at_walls), outline_length(stepped), 1e-12);
}

TEST(SteppedCut, OfBodiesHasAFaceForEach) {
  const world::World world = world_of({box({0, 0, 0}, {4, 6, 4}), box({4, 0, 0}, {8, 6, 2})});
  const cut::CutWorld stepped = cut(world, {{0, 1, 0}, {2, 1, 0}, {2, 3, 0}, {8, 3, 0}});
  ASSERT_EQ(stepped.faces.size(), 2U);
  EXPECT_EQ(stepped.faces[0].rings.size(), 2U);
  EXPECT_EQ(stepped.faces[1].rings.size(), 1U);
  EXPECT_DOUBLE_EQ(cut_area(world, stepped), 16 + 8);
}

TEST(SteppedCut, OfBodiesWithAFaceInCommonHasAFaceForEach) {
  Shape both = box({0, 0, 0}, {4, 6, 4});
  both.add(box({4, 0, 0}, {8, 6, 4}));
  const world::World world = world_of({both});
  const cut::CutWorld stepped = cut(world, {{0, 1, 0}, {2, 1, 0}, {2, 3, 0}, {8, 3, 0}});
  EXPECT_TRUE(stepped.open.empty());
  ASSERT_EQ(stepped.faces.size(), 2U);
  EXPECT_NE(stepped.faces[0].body, stepped.faces[1].body);
  EXPECT_DOUBLE_EQ(cut_area(world, stepped), 32);
}

TEST(SteppedCut, AHalfSectionOfARingHasHalfTheArea) {
  for (const int around : {32, 33}) {
    const world::World world = world_of(ring(around));
    const cut::CutWorld whole = cut(world, {{-5, 0, 0}, {5, 0, 0}});
    const cut::CutWorld half = cut(world, {{0, -5, 0}, {0, 0, 0}, {5, 0, 0}});
    const cut::CutWorld other = cut(world, {{-5, 0, 0}, {0, 0, 0}, {0, -5, 0}});
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
  const world::World world = world_of(box({0, 0, 0}, {10, 6, 4}));
  const cut::CutWorld stepped = cut(world, {{0, 1, 0}, {3, 1, 0}, {3, 4, 0}, {10, 4, 0}});
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
  const cut::CuttingSurface straight = surface({{0, 1, 0}, {3, 1, 0}, {7, 1, 0}});
  EXPECT_TRUE(straight.is_plane());
}

TEST(SteppedCut, MayLeaveCutFacesOnly) {
  const world::World world = world_of(ring(32));
  for (const std::vector<Vec3>& path :
       {std::vector<Vec3>{{-5, 0, 0}, {5, 0, 0}}, std::vector<Vec3>{{-5, 0, 0}, {0, 0, 0}, {0, -5, 0}}}) {
    cut::CuttingSurface section = surface(path);
    section.beyond = false;
    const cut::CutWorld faces = cut::cut_world(world, section);
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
  std::vector<Vec3> staircase{{0, 0, 0}};
  while (staircase.size() < 400)
    staircase.push_back(staircase.back() + (staircase.size() % 2 == 0 ? Vec3(0, 1, 0) : Vec3(1, 0, 0)));
  EXPECT_EQ(surface(staircase).regions.size(), 200U);
  staircase.emplace_back(200, 200, 0);
  refused(staircase, "the path has 401 points, allowed are 400");
}

TEST(SteppedCut, RefusesSurfacesThatMiss) {
  const world::World world = world_of(box({0, 0, 0}, {10, 6, 4}));
  const auto refused = [&](double first, double second, const std::string& why) {
    const std::vector<Vec3> path{{0, first, 0}, {5, first, 0}, {5, second, 0}, {9, second, 0}};
    const std::string what = error_of([&] { cut(world, path); }).what();
    EXPECT_TRUE(contains(what, why)) << what;
  };
  refused(7, 8, "removes everything");
  refused(-7, -8, "cuts nothing");
}

// In front of each plane, everything is removed; beside a half section, nothing is.
TEST(SteppedCut, KeepsWhatIsNotInFrontOfIt) {
  const cut::CuttingSurface stepped = surface({{-9, 1, 0}, {2, 1, 0}, {2, 4, 0}, {9, 4, 0}});
  EXPECT_TRUE(cut::keeps(stepped, {0, 2, 5}, 1e-6));
  EXPECT_TRUE(cut::keeps(stepped, {0, 1, 5}, 1e-6));
  EXPECT_FALSE(cut::keeps(stepped, {0, 0.5, 5}, 1e-6));
  EXPECT_FALSE(cut::keeps(stepped, {5, 2, 5}, 1e-6));
  EXPECT_TRUE(cut::keeps(stepped, {5, 5, 5}, 1e-6));
  const cut::CuttingSurface half = surface({{0, -9, 0}, {0, 1, 0}, {9, 1, 0}});
  EXPECT_TRUE(cut::keeps(half, {-5, -5, 0}, 1e-6));
  EXPECT_FALSE(cut::keeps(half, {5, -5, 0}, 1e-6));
}

cut::CuttingSurface aligned(const std::vector<Vec3>& path, const Vec3& normal = {0, -1, 0}) {
  scene::SectionDescription section{{"A", "a.toml:3:1"}, Vec3(0), normal, {path, "a.toml:4:8"}};
  section.aligned = {true, "a.toml:5:1"};
  return cut::make_cutting_surface(section);
}

// At an angle in the plane z = 0.
Vec3 at(double degrees, double radius) {
  return {radius * std::cos(degrees * pi / 180), radius * std::sin(degrees * pi / 180), 0};
}

// Distances along the picture, and heights over it, of all corners of cut faces.
void expect_in_picture(const cut::CutWorld& cut, double least, double most) {
  double left = 0, right = 0;
  for (const cut::WorldCutFace& face : cut.faces)
    for (const auto& ring : face.rings)
      for (const int v : ring) {
        const Vec3& p = cut.world.points[v];
        EXPECT_NEAR(p.y, 0, 1e-14);
        EXPECT_GE(std::abs(p.x), least - 1e-12);
        left = std::min(left, p.x);
        right = std::max(right, p.x);
      }
  EXPECT_NEAR(left, -most, 1e-12);
  EXPECT_NEAR(right, most, 1e-12);
}

// Whatever their angle, the planes of a ring show what a plane through its axis shows.
TEST(AlignedCut, OfARingShowsItsSectionTwice) {
  const world::World world = world_of(ring(48));
  for (const double angle : {-75.0, -60.0, -7.5, 30.0, 60.0, 90.0, 120.0}) {
    const cut::CutWorld cut = cut::cut_world(world, aligned({at(180, 5), Vec3(0), at(angle, 5)}));
    ASSERT_EQ(cut.world.models.size(), 2U);
    EXPECT_EQ(cut.world.number_in_scene(1), 0);
    EXPECT_TRUE(cut.open.empty());
    EXPECT_NEAR(cut_area(world, cut), 2, 1e-12) << angle;
    EXPECT_NEAR(outline_length(cut), 4, 1e-12) << angle;  // of the first plane
    expect_in_picture(cut, 2, 3);
  }
}

// Each plane keeps what is perpendicular to it and behind it: of a ring, a quarter.
TEST(AlignedCut, KeepsWhatIsBehindEachPlane) {
  const world::World world = world_of(ring(48));
  const double quarter = surface_area(world) / 4;
  for (const double angle : {-45.0, 60.0}) {
    const cut::CutWorld cut = cut::cut_world(world, aligned({at(180, 5), Vec3(0), at(angle, 5)}));
    EXPECT_NEAR(surface_area(cut.world) - cut_area(world, cut), 2 * quarter, 1e-12);
    for (const auto& triangle : cut.world.triangles)
      for (const int v : triangle) EXPECT_GE(cut.world.points[v].y, -1e-12);
  }
}

// The area is the sum of those of the planes, also where these differ.
TEST(AlignedCut, AreasOfPlanesAddUp) {
  const world::World world = world_of(box({-3, -3, 0}, {5, 4, 2}));
  for (const auto& [angle, length] : {std::pair(90.0, 4.0), {-90.0, 3.0}, {45.0, 4 * std::sqrt(2.0)}}) {
    const cut::CutWorld cut = cut::cut_world(world, aligned({at(180, 9), Vec3(0), at(angle, 9)}));
    EXPECT_NEAR(cut_area(world, cut), 2 * (3 + length), 1e-12) << angle;
    double right = 0;
    for (const cut::WorldCutFace& face : cut.faces)
      for (const auto& outline : face.rings)
        for (const int v : outline) right = std::max(right, cut.world.points[v].x);
    EXPECT_NEAR(right, length, 1e-12);
  }
}

// Three planes: the outer ones are turned about the corners next to the middle one, which stays.
TEST(AlignedCut, OfThreePlanesIsAsLongAsThePath) {
  const world::World world = world_of(box({-2, -9, 0}, {6, 9, 2}));
  const cut::CutWorld cut = cut::cut_world(world, aligned({{-2, -3, 0}, {0, 0, 0}, {4, 0, 0}, {6, 3, 0}}));
  ASSERT_EQ(cut.world.models.size(), 3U);
  const double inclined = std::hypot(2.0, 3.0);
  EXPECT_NEAR(cut_area(world, cut), 2 * (4 + 2 * inclined), 1e-12);
  double left = 0, right = 0;
  for (const cut::WorldCutFace& face : cut.faces)
    for (const auto& outline : face.rings)
      for (const int v : outline) {
        left = std::min(left, cut.world.points[v].x);
        right = std::max(right, cut.world.points[v].x);
        EXPECT_NEAR(cut.world.points[v].y, 0, 1e-12);
      }
  EXPECT_NEAR(left, -inclined, 1e-12);
  EXPECT_NEAR(right, 4 + inclined, 1e-12);
}

// A step between two planes in one direction is not cut: an offset in the plane that stays, and in an inclined one.
TEST(AlignedCut, MayHaveSteps) {
  const world::World world = world_of(box({-3, -3, 0}, {5, 4, 2}));
  const cut::CuttingSurface ahead = aligned({{-3, 0, 0}, {1, 0, 0}, {1, 2, 0}, {3, 2, 0}, {5, 4, 0}});
  EXPECT_EQ(ahead.path.size(), 5U) << "the line of the planes has all corners";
  const cut::CutWorld cut = cut::cut_world(world, ahead);
  ASSERT_EQ(cut.world.models.size(), 3U);
  EXPECT_NEAR(cut_area(world, cut), 2 * (4 + 2 + 2 * std::sqrt(2.0)), 1e-12);
  double left = 0, right = 0, far = 0;
  for (const cut::WorldCutFace& face : cut.faces)
    for (const auto& outline : face.rings)
      for (const int v : outline) {
        const Vec3& p = cut.world.points[v];
        left = std::min(left, p.x), right = std::max(right, p.x), far = std::max(far, p.y);
      }
  EXPECT_NEAR(left, -3, 1e-12);
  EXPECT_NEAR(right, 3 + 2 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(far, 2, 1e-12) << "the plane behind the step";
  // From (0, 0) up to the right by 45 degrees, with a step of length sqrt 2 to the lower right at (1, 1).
  const cut::CutWorld inclined =
      cut::cut_world(world, aligned({{-3, 0, 0}, {0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {5, 3, 0}}));
  EXPECT_NEAR(cut_area(world, inclined), 2 * (3 + std::sqrt(2.0) + 3 * std::sqrt(2.0)), 1e-12);
}

// A plane may lie wholly in a hole, between others that cut.
TEST(AlignedCut, MayCrossAHole) {
  const world::World world = world_of(std::vector{box({-3, -4, 0}, {-1, 4, 2}), box({1, -4, 0}, {3, 4, 2})});
  const cut::CutWorld cut = cut::cut_world(world, aligned({{-5, 0, 0}, {-0.5, 0, 0}, {0.5, 1, 0}, {5, 1, 0}}));
  EXPECT_NEAR(cut_area(world, cut), 2 * (2 + 2), 1e-12);
}

// If no plane is perpendicular to the normal, all are turned about their first corner.
TEST(AlignedCut, MayTurnAllPlanes) {
  const world::World world = world_of(ring(48));
  const cut::CutWorld cut = cut::cut_world(world, aligned({at(210, 5), Vec3(0), at(-30, 5)}));
  EXPECT_NEAR(cut_area(world, cut), 2, 1e-12);
  expect_in_picture(cut, 2, 3);
}

TEST(AlignedCut, MayLeaveCutFacesOnly) {
  const world::World world = world_of(ring(48));
  cut::CuttingSurface section = aligned({at(180, 5), Vec3(0), at(60, 5)});
  section.beyond = false;
  EXPECT_NEAR(surface_area(cut::cut_world(world, section).world), 2, 1e-12);
}

// With its hint on a second line.
template <class Action>
std::string text_of_error(Action action) {
  const Error error = error_of(action);
  return std::string(error.what()) + "\n" + error.hint();
}

TEST(AlignedCut, RefusesPathsThatAreNone) {
  const auto error = [](const std::vector<Vec3>& path) { return text_of_error([&] { aligned(path); }); };
  EXPECT_EQ(error({{-5, 0, 0}, {5, 0, 0}}),
            "a.toml:4:8: the path of the aligned section has no corner, so there is no axis to turn a plane about\n"
            "give a corner in which two planes meet, such as a point of the axis of a round part, or omit 'aligned'");
  EXPECT_EQ(error({{-5, 0, 0}, {0, 0, 0}, {-3, 0, 0}}),
            "a.toml:4:8: the path goes back on itself at point 2 of the path\ngive its points in one direction");
  EXPECT_EQ(error({{-5, 0, 0}, {0, 0, 0}, {0, 4, 0}, {-9, 4, 0}, {-9, -1, 0}}),
            "a.toml:4:8: the path crosses itself\nits first and last plane reach to infinity, and must not meet");
  EXPECT_EQ(error({{-5, 0, 0}, {0, 0, 0}, {0, 0, 0}}),
            "a.toml:4:8: point 3 of the path is the same as the one before it\nremove it");
  scene::SectionDescription without{{"A", "a.toml:3:1"}};
  without.aligned = {true, "a.toml:5:1"};
  EXPECT_EQ(text_of_error([&] { cut::make_cutting_surface(without); }),
            "a.toml:5:1: an aligned section has no path\n"
            "give the corners of the cutting-plane line: an end, a point of the axis, the other end");
}

TEST(AlignedCut, RefusesPlanesThatMiss) {
  const world::World world = world_of(box({0, 0, 0}, {10, 6, 4}));
  const cut::CuttingSurface section = aligned({{-5, 3, 0}, {12, 3, 0}, {14, 5, 0}});
  EXPECT_EQ(text_of_error([&] { cut::cut_world(world, section); }),
            "a.toml:3:1: the plane of the aligned section that begins at 12, 3, 0 cuts nothing\n"
            "the models reach from 0 to 10 along x, 0 to 6 along y and 0 to 4 along z: move the corners of the path");
}

}  // namespace
}  // namespace epura::test::stepped_cut_test
