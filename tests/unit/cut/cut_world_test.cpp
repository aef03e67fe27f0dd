// SPDX-License-Identifier: Apache-2.0
#include "cut/cut_world.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>
#include <random>
#include <set>
#include <tuple>

#include "errors.hpp"
#include "scene/transform.hpp"
#include "shapes.hpp"
#include "surfaces/recognise.hpp"

namespace epura::test::cut_world_test {
namespace {

constexpr double pi = std::numbers::pi;

scene::CuttingPlane plane_at(const Vec3& point, const Vec3& normal) {
  return scene::make_cutting_plane({{"A", "--section"}, point, normal});
}

cut::CutWorld cut(const world::World& world, const Vec3& point, const Vec3& normal) {
  return cut::cut_world(world, plane_at(point, normal));
}

double area(const world::World& world, int triangle) {
  const auto [a, b, c] = world.triangles[triangle];
  return glm::length(glm::cross(world.points[b] - world.points[a], world.points[c] - world.points[a])) / 2;
}

// Of the triangles of cut faces: their polygons are numbered behind those of the file.
double cut_area(const world::World& whole, const cut::CutWorld& cut) {
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

// The same from rings. The sums of all are alike where rings of one face are nested no deeper than holes.
double ring_area(const world::World& world, const std::vector<int>& ring) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += glm::cross(world.points[ring[i]] - world.points[ring[0]],
                      world.points[ring[(i + 1) % ring.size()]] - world.points[ring[0]]);
  return glm::length(sum) / 2;
}

double surface_area(const world::World& world) {
  double sum = 0;
  for (std::size_t t = 0; t < world.triangles.size(); ++t) sum += area(world, static_cast<int>(t));
  return sum;
}

double outline_length(const cut::CutWorld& cut) {
  double sum = 0;
  for (std::size_t m = 0; m < cut.world.models.size(); ++m)
    for (const mesh::MeshEdge& edge : cut.world.models[m].mesh->edges) {
      const int first = cut.world.first_vertex[m];
      if (edge.cut == mesh::CutEdge::outline)
        sum += glm::distance(cut.world.points[first + edge.vertex[0]], cut.world.points[first + edge.vertex[1]]);
    }
  return sum;
}

Shape inside_out(Shape shape) {
  for (auto& face : shape.faces) std::reverse(face.begin(), face.end());
  return shape;
}

Shape joined(Shape shape, const Shape& other) {
  shape.add(other);
  return shape;
}

// A profile in the x, z plane, counterclockwise from the front, from y = 0 to y = depth.
Shape prism(const std::vector<std::array<double, 2>>& profile, double depth) {
  Shape shape;
  const int n = static_cast<int>(profile.size());
  for (const double y : {0.0, depth})
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

// Turned about the z axis: rings of `around` places at each (radius, height) of a profile; closed on itself or by
// poles.
Shape turned(const std::vector<std::array<double, 2>>& profile, int around, bool closed) {
  Shape shape;
  const int n = static_cast<int>(profile.size());
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < around; ++k) {
      const double a = 2 * pi * k / around;
      shape.points.push_back({profile[i][0] * std::cos(a), profile[i][0] * std::sin(a), profile[i][1]});
    }
  const auto place = [&](int i, int k) { return (i % n) * around + k % around; };
  for (int i = 0; i + (closed ? 0 : 1) < n; ++i)
    for (int k = 0; k < around; ++k)
      shape.faces.push_back({place(i, k), place(i, k + 1), place(i + 1, k + 1), place(i + 1, k)});
  if (closed) return shape;
  std::vector<int> bottom, top;
  for (int k = 0; k < around; ++k) {
    bottom.push_back(place(0, around - k));
    top.push_back(place(n - 1, k));
  }
  shape.faces.push_back(bottom);
  shape.faces.push_back(top);
  return shape;
}

Shape torus(double large, double small, int around, int across) {
  std::vector<std::array<double, 2>> profile;
  for (int i = 0; i < across; ++i)
    profile.push_back({large + small * std::cos(2 * pi * i / across), small * std::sin(2 * pi * i / across)});
  return turned(profile, around, true);
}

double polygon_area(int n, double radius) { return n / 2.0 * std::sin(2 * pi / n) * radius * radius; }

TEST(CutWorld, OfBodiesWithAFaceInCommonHasAFaceForEach) {
  const Shape left = box({0, 0, 0}, {20, 20, 10}), right = box({20, 0, 0}, {50, 20, 10});
  for (const Shape& both : {joined(left, right), joined(right, left), inside_out(joined(left, right))}) {
    const cut::CutWorld result = cut(world_of({both}), {0, 10, 0}, {0, -1, 0});
    ASSERT_EQ(result.faces.size(), 2U);
    EXPECT_NE(result.faces[0].body, result.faces[1].body);
    for (const cut::WorldCutFace& face : result.faces)
      EXPECT_TRUE(std::set({200.0, 300.0}).contains(ring_area(result.world, face.rings.at(0))));
  }
}

TEST(CutWorld, OfACubeIsHalfACube) {
  const world::World cube = world_of(box({0, 0, 0}, {2, 2, 2}));
  const cut::CutWorld half = cut(cube, {0, 0.5, 0}, {0, -3, 0});
  ASSERT_EQ(half.faces.size(), 1U);
  ASSERT_EQ(half.faces[0].rings.size(), 1U);
  EXPECT_TRUE(half.open.empty());
  EXPECT_DOUBLE_EQ(cut_area(cube, half), 4);
  EXPECT_DOUBLE_EQ(ring_area(half.world, half.faces[0].rings[0]), 4);
  EXPECT_DOUBLE_EQ(surface_area(half.world), 2 * 4 + 4 * 1.5 * 2);
  EXPECT_DOUBLE_EQ(outline_length(half), 8);
  for (const auto& corners : half.world.triangles)
    for (const int v : corners) EXPECT_GE(half.world.points[v].y, 0.5);
}

TEST(CutWorld, EdgesKeepTheirNumbersAndParameters) {
  const world::World cube = world_of({plate(0, 0, 1, 1, -9), box({0, 0, 0}, {2, 2, 2})});
  const cut::CutWorld half = cut(cube, {0, 0.5, 0}, {0, -1, 0});
  const mesh::Mesh& mesh = *half.world.models[1].mesh;
  int cut_edges = 0, whole = 0;
  for (const mesh::MeshEdge& edge : mesh.edges) {
    if (edge.cut == mesh::CutEdge::inside || edge.diagonal) continue;
    const mesh::EdgeOrigin origin = mesh.origin_of(edge);
    if (!origin.in_file) {
      EXPECT_EQ(edge.cut, mesh::CutEdge::outline);
      continue;
    }
    const int old = cube.first_vertex[1], first = half.world.first_vertex[1];
    const Vec3 p = cube.points[old + origin.vertex[0]], q = cube.points[old + origin.vertex[1]];
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_LT(glm::distance(half.world.points[first + edge.vertex[i]], p + origin.t[i] * (q - p)), 1e-15);
    const bool is_cut = edge.vertex[1] >= 8;
    (is_cut ? cut_edges : whole) += 1;
    EXPECT_TRUE(!is_cut || origin.t[1] == 0.25 || origin.t[1] == 0.75);
  }
  EXPECT_EQ(cut_edges, 4);
  EXPECT_EQ(whole, 4);
}

TEST(CutWorld, DoesNotDependOnHowAPartStands) {
  const Shape shape = box({-1, -2, -3}, {1, 2, 3});
  const world::World straight = world_of(shape);
  const Vec3 point(0.1, 0.2, 0.3), normal(0.3, 0.5, 0.8);
  const double expected = cut_area(straight, cut(straight, point, normal));
  EXPECT_GT(expected, 8);
  const Mat4 turn = glm::translate(glm::rotate(Mat4(1), 0.7, Vec3(0.2, -0.6, 0.77)), Vec3(5, 6, 7));
  const world::World moved = world::make_world({{std::make_shared<const mesh::Mesh>(mesh_of(shape)), turn}});
  const Vec3 new_point(turn * Vec4(point, 1)), new_normal(turn * Vec4(normal, 0));
  EXPECT_NEAR(cut_area(moved, cut(moved, new_point, new_normal)), expected, 1e-12);
}

TEST(CutWorld, LeavesAMeshOfItsOwn) {
  const Mat4 turn = glm::translate(glm::rotate(Mat4(1), 0.7, Vec3(0.2, -0.6, 0.77)), Vec3(5, 6, 7));
  const world::World whole =
      world::make_world({{std::make_shared<const mesh::Mesh>(mesh_of(box({-1, -2, -3}, {1, 2, 3}))), turn},
                         {std::make_shared<const mesh::Mesh>(mesh_of(torus(5, 2, 12, 8))),
                          scene::parse_transform("scale:2,1,1 translate:5,6,7")}});
  const world::World left = cut(whole, {5, 6, 7}, {0.3, 0.5, 0.8}).world;
  for (std::size_t m = 0; m < 2; ++m) {
    const mesh::Mesh& mesh = *left.models[m].mesh;
    ASSERT_EQ(mesh.uncut, whole.models[m].mesh);
    ASSERT_FALSE(mesh.cut_vertices.empty());
    ASSERT_EQ(static_cast<int>(mesh.points.size()), left.first_vertex[m + 1] - left.first_vertex[m]);
    for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
      const Vec3 there(left.models[m].to_world * Vec4(mesh.point(v), 1));
      EXPECT_LT(glm::distance(there, left.points[left.first_vertex[m] + v]), 1e-13) << m << " " << v;
    }
    for (int t = 0; t < mesh.triangle_count(); ++t) {
      std::array<int, 3> corners = mesh.triangle(t);
      for (int& v : corners) v += left.first_vertex[m];
      EXPECT_EQ(corners, left.triangles[left.first_triangle[m] + t]);
    }
  }
}

TEST(CutWorld, BothSidesAreCutAlike) {
  const world::World world = world_of(torus(5, 2, 48, 24));
  const Vec3 normal(0.2, 0.3, 0.9), point(0.4, 0.1, 0.2);
  const cut::CutWorld one = cut(world, point, normal), other = cut(world, point, -normal);
  EXPECT_NEAR(cut_area(world, one), cut_area(world, other), 1e-12);
  EXPECT_NEAR(surface_area(one.world) + surface_area(other.world), surface_area(world) + 2 * cut_area(world, one),
              1e-10);
}

TEST(CutWorld, OfASphereThroughAndBetweenItsRings) {
  std::vector<std::array<double, 2>> profile;
  constexpr int bands = 16, around = 40;
  for (int i = 1; i < bands; ++i) profile.push_back({10 * std::sin(pi * i / bands), -10 * std::cos(pi * i / bands)});
  const world::World sphere = world_of(turned(profile, around, false));
  const cut::CutWorld middle = cut(sphere, {0, 0, 0}, {0, 0, 1});
  ASSERT_EQ(middle.faces.size(), 1U);
  EXPECT_EQ(middle.faces[0].rings[0].size(), std::size_t{around});
  EXPECT_NEAR(cut_area(sphere, middle), polygon_area(around, 10), 1e-11);
  const double radius = (10 + profile[8][0]) / 2, height = profile[8][1] / 2;
  EXPECT_NEAR(cut_area(sphere, cut(sphere, {0, 0, height}, {0, 0, 1})), polygon_area(around, radius), 1e-11);
  // Through both poles, along edges.
  const cut::CutWorld along = cut(sphere, {0, 0, 0}, {0, 1, 0});
  double expected = 0;
  for (std::size_t i = 1; i < profile.size(); ++i)
    expected += (profile[i][0] + profile[i - 1][0]) * (profile[i][1] - profile[i - 1][1]);
  EXPECT_NEAR(cut_area(sphere, along), expected, 1e-11);
}

TEST(CutWorld, OfATorusIsTwoDiscsOrARing) {
  constexpr int around = 32, across = 20;
  const world::World world = world_of(torus(10, 3, around, across));
  const cut::CutWorld discs = cut(world, {0, 0, 0}, {0, 1, 0});
  ASSERT_EQ(discs.faces.size(), 1U);  // of one body
  EXPECT_EQ(discs.faces[0].rings.size(), 2U);
  EXPECT_NEAR(cut_area(world, discs), 2 * polygon_area(across, 3), 1e-11);
  const cut::CutWorld ring = cut(world, {0, 0, 0}, {0, 0, -1});
  ASSERT_EQ(ring.faces.size(), 1U);
  EXPECT_EQ(ring.faces[0].rings.size(), 2U);
  EXPECT_NEAR(cut_area(world, ring), polygon_area(around, 13) - polygon_area(around, 7), 1e-10);
  // Tangent to the inside: the rings of the figure eight touch, or nearly do.
  EXPECT_NEAR(cut_area(world, cut(world, {0, 7, 0}, {0, 1, 0})), cut_area(world, cut(world, {0, 7, 0}, {0, -1, 0})),
              1e-10);
}

TEST(CutWorld, CavitiesAreHolesAndNestedBodiesAreNot) {
  const Shape outside = box({0, 0, 0}, {10, 10, 10}), inside = box({2, 2, 2}, {8, 8, 8}),
              ball = box({4, 4, 4}, {6, 6, 6});
  const world::World hollow = world_of(joined(outside, inside_out(inside)));
  const cut::CutWorld hole = cut(hollow, {0, 5, 0}, {0, -1, 0});
  ASSERT_EQ(hole.faces.size(), 1U);
  EXPECT_EQ(hole.faces[0].rings.size(), 2U);
  EXPECT_DOUBLE_EQ(cut_area(hollow, hole), 100 - 36);

  const world::World nested = world_of(joined(outside, inside));
  const cut::CutWorld two = cut(nested, {0, 5, 0}, {0, -1, 0});
  ASSERT_EQ(two.faces.size(), 2U);
  EXPECT_DOUBLE_EQ(cut_area(nested, two), 100) << "the inner one covers the outer one";

  const world::World rattle = world_of(joined(joined(outside, inside_out(inside)), ball));
  const cut::CutWorld three = cut(rattle, {0, 5, 0}, {0, -1, 0});
  ASSERT_EQ(three.faces.size(), 2U);
  EXPECT_DOUBLE_EQ(cut_area(rattle, three), 100 - 36 + 4);
  EXPECT_EQ(three.faces[0].body, 0);
  EXPECT_EQ(three.faces[1].body, 2);

  // A file that is inside out as a whole.
  const world::World wrong = world_of(joined(inside_out(outside), inside));
  EXPECT_DOUBLE_EQ(cut_area(wrong, cut(wrong, {0, 5, 0}, {0, -1, 0})), 100 - 36);
}

TEST(CutWorld, OfOtherModelsAndTouchingBoxesEachHasItsFace) {
  const world::World world =
      world_of({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {3, 1, 1}), box({0.5, 0, 0.5}, {1.5, 1, 2})});
  const cut::CutWorld faces = cut(world, {0, 0.5, 0}, {0, -1, 0});
  ASSERT_EQ(faces.faces.size(), 3U);
  for (int m = 0; m < 3; ++m) EXPECT_EQ(faces.faces[m].model, m);
  EXPECT_DOUBLE_EQ(cut_area(world, faces), 1 + 2 + 1.5 - 2 * 0.25) << "what two have in common is cut once";
}

TEST(CutWorld, AFaceInThePlaneIsNotCut) {
  // A step at z = 1, a column from x = 0 to 1 up to z = 3, and a notch from below up to z = 1 at x = 0.2 to 0.4.
  const Shape step = prism({{0, 0}, {0.2, 0}, {0.2, 1}, {0.4, 1}, {0.4, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 2);
  const world::World world = world_of(step);
  const cut::CutWorld low = cut(world, {0, 0, 1}, {0, 0, 1});
  EXPECT_NEAR(cut_area(world, low), (1 - 0.2) * 2, 1e-15);
  // All of the cut, the step, and the sides.
  EXPECT_NEAR(surface_area(low.world), 2 * (3 - 0.2) * 2 + 2 * 2.8 + 2 * 2 + 2 * 2, 1e-12);
  const cut::CutWorld high = cut(world, {0, 0, 1}, {0, 0, -1});
  EXPECT_NEAR(cut_area(world, high), (1 - 0.2) * 2, 1e-15);
  EXPECT_NEAR(surface_area(high.world), 2 * 1 * 2 + 2 * (1 + 2) * 2, 1e-12);
}

TEST(CutWorld, ACavityMayEndInThePlane) {
  const world::World hollow = world_of(joined(box({0, 0, 0}, {10, 10, 10}), inside_out(box({2, 2, 2}, {8, 8, 8}))));
  for (const double sign : {1.0, -1.0}) {
    const cut::CutWorld at_end = cut(hollow, {0, 0, 8}, {0, 0, sign});
    EXPECT_DOUBLE_EQ(cut_area(hollow, at_end), 100 - 36);
    // Above, the ceiling stays, below, the walls of the cavity.
    const double expected = sign > 0 ? 100 + 4 * 80 + 64 + 36 + 4 * 36 : 100 + 4 * 20 + 64 + 36;
    EXPECT_DOUBLE_EQ(surface_area(at_end.world), expected);
  }
}

TEST(CutWorld, ThroughVerticesAndDiagonals) {
  const world::World cube = world_of(triangulated_cube()), other = world_of(triangulated_cube(true));
  for (const world::World* world : {&cube, &other})
    for (const Vec3& normal : {Vec3(1, 1, 0), Vec3(1, -1, 0), Vec3(0, 1, 1), Vec3(-1, 0, 1)}) {
      const cut::CutWorld half = cut(*world, {0.5, 0.5, 0.5}, normal);
      EXPECT_NEAR(cut_area(*world, half), std::sqrt(2), 1e-15);
      EXPECT_NEAR(surface_area(half.world), 3 + std::sqrt(2), 1e-14);
    }
  // Through three corners.
  EXPECT_NEAR(cut_area(cube, cut(cube, {1, 0, 0}, {1, 1, 1})), std::sqrt(3) / 2, 1e-15);
  EXPECT_NEAR(cut_area(cube, cut(cube, {1, 0, 0}, {-1, -1, -1})), std::sqrt(3) / 2, 1e-15);
}

TEST(CutWorld, RoundingDoesNotMoveVerticesOffThePlane) {
  Shape shape = torus(10, 3, 64, 32);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> noise(-1e-14, 1e-14);
  for (Point& p : shape.points)
    for (double& x : p) x += noise(random);
  const world::World world = world_of(shape);
  const cut::CutWorld half = cut(world, {0, 0, 0}, {0, 1, 0});
  EXPECT_TRUE(half.world.models[0].mesh->cut_vertices.empty() ||
              half.world.models[0].mesh->cut_vertices[0].edge[0] == -1);
  EXPECT_NEAR(cut_area(world, half), 2 * polygon_area(32, 3), 1e-11);
}

TEST(CutWorld, OpenOutlinesAreReportedAndNotFilled) {
  const world::World strip = world_of(moebius(24));
  const cut::CutWorld cut_strip = cut(strip, {0, 0, 0}, {0, 1, 0});
  EXPECT_TRUE(cut_strip.faces.empty());
  ASSERT_EQ(cut_strip.open.size(), 1U);
  EXPECT_NEAR(cut_strip.open[0].end.y, 0, 1e-15);
  EXPECT_GT(outline_length(cut_strip), 0.5);

  Shape open = box({0, 0, 0}, {2, 2, 2});
  std::erase_if(open.faces, [&](const auto& f) {
    return std::all_of(f.begin(), f.end(), [&](int v) { return open.points[v][2] == 2; });
  });
  ASSERT_EQ(open.faces.size(), 5U);
  const world::World world = world_of({open, box({4, 0, 0}, {5, 2, 2})});
  for (const Vec3& normal : {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
    const cut::CutWorld half = cut(world, {1, 1, 1}, normal);
    EXPECT_TRUE(half.bridged.empty());
    if (normal.y == 0) {  // the lid is elsewhere
      EXPECT_TRUE(half.open.empty());
      EXPECT_DOUBLE_EQ(cut_area(world, half), 4 + 2);
      continue;
    }
    ASSERT_EQ(half.open.size(), 1U);
    EXPECT_EQ(half.open[0].model, 0);
    EXPECT_NEAR(half.open[0].end.z, 2, 1e-15);
    ASSERT_EQ(half.faces.size(), 1U);
    EXPECT_EQ(half.faces[0].model, 1);
    EXPECT_DOUBLE_EQ(outline_length(half), 2 * 3 + 2 * (1 + 2));
  }
}

// Without the faces whose vertices all satisfy a condition.
template <class Condition>
Shape without(Shape shape, const Condition& condition) {
  const std::size_t before = shape.faces.size();
  std::erase_if(shape.faces, [&](const auto& face) {
    return std::all_of(face.begin(), face.end(), [&](int v) { return condition(shape.points[v]); });
  });
  EXPECT_LT(shape.faces.size(), before);
  return shape;
}

TEST(CutWorld, BodiesThatShareAnEdgeAreCutEachByItself) {
  Shape cubes = joined(box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1}));
  for (auto& face : cubes.faces)
    for (int& v : face)
      v = static_cast<int>(std::find(cubes.points.begin(), cubes.points.end(), cubes.points[v]) - cubes.points.begin());
  const world::World world = world_of(cubes);
  const cut::CutWorld half = cut(world, {0, 0, 0.5}, {0, 0, 1});
  ASSERT_EQ(half.faces.size(), 2U);
  for (const cut::WorldCutFace& face : half.faces) {
    ASSERT_EQ(face.rings.size(), 1U);
    EXPECT_DOUBLE_EQ(ring_area(half.world, face.rings[0]), 1);
  }
}

TEST(CutWorld, ACrackElsewhereDoesNotMatter) {
  // A fork whose left prong has no outer wall: open where that is cut, closed through its base.
  const Shape fork = without(prism({{0, 0}, {3, 0}, {3, 1}, {3, 5}, {2, 5}, {2, 1}, {1, 1}, {1, 5}, {0, 5}, {0, 1}}, 2),
                             [](const Point& p) { return p[0] == 0 && p[2] >= 1; });
  const world::World world = world_of(fork);
  const cut::CutWorld base = cut(world, {0, 0, 0.5}, {0, 0, 1});
  EXPECT_TRUE(base.open.empty());
  EXPECT_TRUE(base.bridged.empty());
  EXPECT_DOUBLE_EQ(cut_area(world, base), 6);
  for (const double sign : {1.0, -1.0}) {
    const cut::CutWorld prongs = cut(world, {0, 0, 3}, {0, 0, sign});
    ASSERT_EQ(prongs.open.size(), 1U);
    EXPECT_EQ(prongs.open[0].end.x, 0);
    EXPECT_EQ(prongs.open[0].end.z, 3);
    EXPECT_DOUBLE_EQ(cut_area(world, prongs), 2);  // of the right one
    EXPECT_DOUBLE_EQ(outline_length(prongs), 6 + 4);
  }
}

TEST(CutWorld, ASheetBesideASolidIsLeftOut) {
  Shape fin = box({0, 0, 0}, {2, 2, 2});
  const auto number = [&](const Point& p) {
    return static_cast<int>(std::find(fin.points.begin(), fin.points.end(), p) - fin.points.begin());
  };
  fin.points.insert(fin.points.end(), {{4, 0, 0}, {4, 0, 2}});
  fin.faces.push_back({number({2, 0, 0}), 8, 9, number({2, 0, 2})});
  const world::World world = world_of(fin);
  const cut::CutWorld half = cut(world, {0, 0, 1}, {0, 0, 1});
  ASSERT_EQ(half.open.size(), 1U);
  EXPECT_DOUBLE_EQ(cut_area(world, half), 4);
  EXPECT_DOUBLE_EQ(outline_length(half), 8 + 2);
}

TEST(CutWorld, WhatAnOpenOutlineMayTurnIntoAHoleIsNotFilled) {
  constexpr int around = 12;
  const Shape tube = turned({{2, 0}, {4, 0}, {4, 5}, {2, 5}}, around, true);
  EXPECT_NEAR(cut_area(world_of(tube), cut(world_of(tube), {0, 0, 1}, {0, 0, 1})),
              polygon_area(around, 4) - polygon_area(around, 2), 1e-12);
  const Shape outside = box({-5, -5, 0}, {5, 5, 9}), cavity = inside_out(box({-4, -4, 1}, {4, 4, 8})),
              ball = box({-1, -1, 4}, {1, 1, 6});
  const auto at_wall = [](double x) { return [x](const Point& p) { return p[0] == x; }; };
  const auto holed = [&](int first) {
    Shape shape = tube;
    shape.faces.erase(shape.faces.begin() + first);
    return shape;
  };
  for (const bool reversed : {false, true}) {
    const auto expect_area = [&](const Shape& shape, double expected) {
      const world::World world = world_of(reversed ? inside_out(shape) : shape);
      const cut::CutWorld half = cut(world, {0, 0, 4.5}, {0, 0, 1});
      EXPECT_EQ(half.open.size(), 1U);
      EXPECT_DOUBLE_EQ(cut_area(world, half), expected) << reversed;
    };
    expect_area(holed(around + 3), 0);  // the outer wall
    expect_area(holed(3 * around + 3), 0);
    // The same with shells that are bodies of their own, and one that lies loose inside.
    expect_area(joined(without(outside, at_wall(5)), cavity), 0);
    expect_area(joined(outside, without(cavity, at_wall(4))), 0);
    expect_area(joined(joined(outside, without(cavity, at_wall(4))), ball), 4);
    // An open box beside it, and one in the cavity.
    expect_area(joined(joined(outside, cavity), without(box({7, 0, 0}, {9, 2, 9}), at_wall(9))), 100 - 64);
    expect_area(joined(joined(outside, cavity), without(ball, at_wall(1))), 100 - 64);
  }
}

// A tube whose first and last facet do not meet by `gap`, along a generator.
Shape slit_tube(int around, double radius, double gap) {
  Shape tube = turned({{radius / 2, 0}, {radius, 0}, {radius, 5}, {radius / 2, 5}}, around, true);
  const int points = static_cast<int>(tube.points.size());
  std::vector<int> copy(static_cast<std::size_t>(points), -1);
  for (std::size_t f = 0; f < tube.faces.size(); ++f) {
    if (f % around != 0) continue;
    for (int& v : tube.faces[f]) {
      if (v % around != 0) continue;
      const Point p = tube.points[v];
      // In the plane of the facet, away from its neighbour.
      const double a = pi / around;
      tube.points.push_back({p[0] - gap * std::sin(a), p[1] + gap * std::cos(a), p[2]});
      v = static_cast<int>(tube.points.size()) - 1;
    }
  }
  return tube;
}

TEST(CutWorld, GapsThatTessellationLeavesAreBridged) {
  constexpr int around = 48;
  const double sagitta = 10 * (1 - std::cos(pi / around));
  // On the surface, the vertices on diagonals of facets are corners, too: two fifths of a chord from one of its ends.
  const double turn = pi / around, aside = std::atan(0.2 * std::tan(turn));
  const double corners = around / 2.0 * (std::sin(turn - aside) + std::sin(turn + aside));
  for (const bool with_part : {false, true}) {
    const double whole = with_part ? corners * (100 - 25) : polygon_area(around, 10) - polygon_area(around, 5);
    const auto half_of = [&](double gap) {
      const auto mesh = std::make_shared<const mesh::Mesh>(mesh_of(slit_tube(around, 10, gap)));
      std::shared_ptr<const surfaces::PartFaces> part;
      if (with_part) part = std::make_shared<const surfaces::PartFaces>(surfaces::recognise_faces(*mesh));
      const world::World world = world::make_world({{mesh, Mat4(1), part}});
      const cut::CutWorld half = cut(world, {0, 0, 2}, {0, 0, 1});
      return std::tuple(half.open.size(), half.bridged, cut_area(world, half));
    };
    const double gap = 0.2 * sagitta;
    const auto& [open, bridged, area] = half_of(gap);
    EXPECT_EQ(open, 0U) << with_part;
    ASSERT_EQ(bridged.size(), 1U);
    EXPECT_EQ(bridged[0].count, 2);  // outside and inside
    EXPECT_NEAR(bridged[0].widest, gap, 1e-12);
    EXPECT_NEAR(bridged[0].place.z, 2, 1e-12);
    EXPECT_NEAR(bridged[0].place.y, 0, gap);
    EXPECT_NEAR(area, whole, 10 * gap);
    EXPECT_NE(area, whole);
    for (const double wide : {3 * sagitta, 100 * sagitta}) {
      const auto& [still_open, not_bridged, nothing] = half_of(wide);
      EXPECT_EQ(still_open, 1U) << with_part;
      EXPECT_TRUE(not_bridged.empty());
      EXPECT_EQ(nothing, 0);
    }
  }
}

TEST(CutWorld, GapsInFlatFacesAreNot) {
  Shape slit = box({0, 0, 0}, {2, 2, 2});
  const int points = 8;
  for (int v = 0; v < points; ++v)
    slit.points.push_back({slit.points[v][0] + 1e-4, slit.points[v][1], slit.points[v][2]});
  for (auto& face : slit.faces)
    if (std::all_of(face.begin(), face.end(), [&](int v) { return slit.points[v][0] == 2; }))
      for (int& v : face) v += points;
  const world::World world = world_of(slit);
  const cut::CutWorld half = cut(world, {0, 0, 1}, {0, 0, 1});
  EXPECT_EQ(half.open.size(), 2U);  // the wall stands alone
  EXPECT_TRUE(half.bridged.empty());
  EXPECT_TRUE(half.faces.empty());
}

TEST(CutWorld, OfASoupKeepsWhatLiesBehind) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1, 1);
  Shape soup;
  for (int i = 0; i < 600; ++i) {
    soup.points.push_back({place(random), place(random), place(random)});
    if (i % 3 == 2) soup.faces.push_back({i - 2, i - 1, i});
  }
  const world::World world = world_of(soup);
  const Vec3 normal(0.3, 0.9, -0.2);
  const cut::CutWorld one = cut(world, {0.05, 0.1, 0}, normal), other = cut(world, {0.05, 0.1, 0}, -normal);
  EXPECT_TRUE(one.faces.empty());
  EXPECT_FALSE(one.open.empty());
  EXPECT_NEAR(surface_area(one.world) + surface_area(other.world), surface_area(world), 1e-11);
  EXPECT_NEAR(outline_length(one), outline_length(other), 1e-12);
}

TEST(CutWorld, FarAndSmallWorldsAreCutAlike) {
  const world::World small = world_of(torus(10, 3, 32, 16).scaled(1e-150)),
                     large = world_of(torus(10, 3, 32, 16).scaled(1e140));
  EXPECT_EQ(cut(small, {0, 0, 0}, {0, 1, 0}).faces[0].rings.size(), 2U);
  EXPECT_EQ(cut(large, {0, 0, 0}, {0, 1, 0}).faces[0].rings.size(), 2U);
  const world::World far = world_of(box({0, 0, 0}, {2, 2, 2}).moved(1e9, 2e9, 3e9));
  EXPECT_NEAR(cut_area(far, cut(far, {1e9, 2e9 + 0.5, 3e9}, {0, 1, 0})), 4, 1e-6);
}

TEST(CutWorld, RefusesPlanesThatNeitherCutNorRemoveAnything) {
  const world::World cube = world_of(box({0, 0, 0}, {2, 2, 2}));
  const auto refusal = [&](const world::World& world, const Vec3& point, const Vec3& normal) {
    const Error error = error_of([&] { cut(world, point, normal); });
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_EQ(error.where(), "--section");
    return std::string(error.what());
  };
  EXPECT_TRUE(contains(refusal(cube, {0, 0, 5}, {0, 0, 1}), "cuts nothing"));
  EXPECT_TRUE(contains(refusal(cube, {0, 0, 2}, {0, 0, 1}), "cuts nothing"));
  EXPECT_TRUE(contains(refusal(cube, {0, 0, 5}, {0, 0, -1}), "everything"));
  EXPECT_TRUE(contains(refusal(cube, {0, 0, 2}, {0, 0, -1}), "everything"));
  // In the joint of bodies, it shows those behind it.
  const world::World stack = world_of({box({0, 0, 0}, {2, 2, 2}), box({0, 0, 2}, {2, 2, 4})});
  EXPECT_EQ(cut(stack, {0, 0, 2}, {0, 0, 1}).world.triangles.size(), 12U) << "without cut faces";
}

TEST(CuttingPlane, IsParsedAndNormalised) {
  const scene::CuttingPlane plane = scene::make_cutting_plane(scene::parse_section("1,2,3:0,-2e-200,0", "--section"));
  EXPECT_EQ(plane.point, Vec3(1, 2, 3));
  EXPECT_EQ(plane.normal, Vec3(0, -1, 0));
  EXPECT_LT(glm::distance(glm::cross(plane.right, plane.up), plane.normal), 1e-15);
  const scene::CuttingPlane oblique = plane_at({0, 0, 0}, {1e200, 2e200, -3e200});
  EXPECT_NEAR(glm::length(oblique.normal), 1, 1e-15);
  EXPECT_LT(glm::distance(glm::cross(oblique.right, oblique.up), oblique.normal), 1e-15);
  for (const char* text : {"", "1,2,3", "1,2,3:0,0", "1,2:0,0,1", "a,b,c:0,0,1", "1,2,3:0,0,1:5", "1,2,3:0 0 1"})
    EXPECT_TRUE(contains(error_of([&] { scene::parse_section(text, "--section"); }).what(), "not a cutting plane"))
        << text;
  for (const char* text : {"1,2,3:0,0,0", "nan,2,3:0,0,1", "1,2,3:0,inf,1"})
    EXPECT_EQ(error_of([&] { scene::make_cutting_plane(scene::parse_section(text, "x")); }).where(), "x") << text;
}

}  // namespace
}  // namespace epura::test::cut_world_test
