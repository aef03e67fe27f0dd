// SPDX-License-Identifier: Apache-2.0
// What would break if this were wrong: which edges exist, and therefore every line of a drawing.
#include <cmath>
#include <limits>
#include <numbers>

#include "mesh/weld.hpp"
#include "support.hpp"

namespace epura::build_test {
namespace {

using test::expect_valid;
using test::mesh_of;

constexpr double pi = std::numbers::pi;

int diagonals(const mesh::Mesh& mesh) {
  return static_cast<int>(std::count_if(mesh.edges.begin(), mesh.edges.end(), [](auto& e) { return e.diagonal; }));
}

double area_z(const mesh::Mesh& mesh, int triangle) {
  const auto [a, b, c] = mesh.triangle(triangle);
  return glm::cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a)).z / 2;
}

TEST(Build, CubeOfQuads) {
  const mesh::Mesh mesh = mesh_of(test::unit_cube, test::cube_quads);
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.faces, 6);
  EXPECT_EQ(mesh.report.triangles, 12);
  EXPECT_EQ(mesh.edges.size(), 18u);
  EXPECT_EQ(diagonals(mesh), 6);
  EXPECT_EQ(mesh.report.bodies, 1);
  EXPECT_EQ(mesh.report.open_edges + mesh.report.non_manifold_edges + mesh.report.misoriented_edges, 0);
  EXPECT_EQ(mesh.triangle(0), (std::array<int, 3>{0, 3, 2}));
  EXPECT_EQ(mesh.polygon, (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
}

TEST(Build, ThreeTrianglesOnOneEdgeShareIt) {
  const mesh::Mesh mesh =
      mesh_of({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.non_manifold_edges, 1);
  EXPECT_EQ(mesh.report.open_edges, 6);
  EXPECT_EQ(mesh.edges.size(), 7u);
  EXPECT_EQ(mesh.edges[0].count, 3);
  EXPECT_EQ(mesh.report.bodies, 1);
}

TEST(Build, AFlippedFaceSharesItsEdges) {
  auto quads = test::cube_quads;
  std::reverse(quads[1].begin(), quads[1].end());
  const mesh::Mesh mesh = mesh_of(test::unit_cube, quads);
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.misoriented_edges, 4);
  EXPECT_EQ(mesh.report.open_edges, 0);
  EXPECT_EQ(mesh.edges.size(), 18u);
  EXPECT_EQ(mesh.report.bodies, 1);
}

TEST(Build, MoebiusBandHasOneSeam) {
  constexpr int n = 20;
  mesh::Points points;
  std::vector<std::vector<int>> quads;
  for (int i = 0; i < n; ++i) {
    const double u = 2 * pi * i / n;
    for (const double v : {-0.3, 0.3})
      points.push_back(
          {(1 + v * std::cos(u / 2)) * std::cos(u), (1 + v * std::cos(u / 2)) * std::sin(u), v * std::sin(u / 2)});
    const bool last = i == n - 1;
    const int a = last ? 1 : 2 * i + 2, b = last ? 0 : 2 * i + 3;
    quads.push_back({2 * i, a, b, 2 * i + 1});
  }
  const mesh::Mesh mesh = mesh_of(points, quads);
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 2 * n);
  EXPECT_EQ(mesh.report.misoriented_edges, 1);
  EXPECT_EQ(mesh.report.open_edges, 2 * n);
  EXPECT_EQ(mesh.edges.size(), 4u * n);  // n rungs, n diagonals, 2n at the rim
}

TEST(Build, ATorusIsClosed) {
  constexpr int m = 12, n = 9;
  mesh::Points points;
  std::vector<std::vector<int>> quads;
  for (int i = 0; i < m; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = 2 * pi * i / m, v = 2 * pi * j / n;
      points.push_back({(3 + std::cos(v)) * std::cos(u), (3 + std::cos(v)) * std::sin(u), std::sin(v)});
      const int i1 = (i + 1) % m, j1 = (j + 1) % n;
      quads.push_back({i * n + j, i1 * n + j, i1 * n + j1, i * n + j1});
    }
  const mesh::Mesh mesh = mesh_of(points, quads);
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.open_edges, 0);
  EXPECT_EQ(mesh.points.size() + mesh.polygon.size(), mesh.edges.size());  // Euler's characteristic is zero
}

TEST(Build, TwoConesMeetInAVertex) {
  const mesh::Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}},
                                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 5, 4}, {0, 6, 5}, {0, 4, 6}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.bodies, 2);  // they share no edge
}

TEST(Build, SoupBecomesClosedByWelding) {
  mesh::Points points;
  std::vector<std::vector<int>> quads;
  for (const auto& quad : test::cube_quads) {
    quads.push_back({});
    for (const int corner : quad) {
      quads.back().push_back(static_cast<int>(points.size()));
      points.push_back(test::unit_cube[static_cast<std::size_t>(corner)]);
    }
  }
  points[5][0] = -0.0 + points[5][0];
  const mesh::Mesh mesh = mesh_of(points, quads);
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.welded_vertices, 16);
  EXPECT_EQ(mesh.report.vertices, 24);  // numbers stay those of the file
  EXPECT_EQ(mesh.report.open_edges, 0);
  EXPECT_EQ(mesh.edges.size(), 18u);
  EXPECT_EQ(mesh.triangle(0), (std::array<int, 3>{0, 1, 2}));
  EXPECT_EQ(mesh.triangle(4)[0], 0);  // vertex 8 lies where vertex 0 does
}

TEST(Build, NegativeZeroIsZero) {
  const mesh::Mesh mesh =
      mesh_of({{0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 1}});
  EXPECT_EQ(mesh.report.welded_vertices, 1);
  EXPECT_EQ(mesh.report.open_edges, 4);
}

TEST(Build, NegativeZeroIsZeroInAnyCoordinate) {
  mesh::Points points;
  for (int i = 1; i <= 1000; ++i) {
    const double x = i;
    for (const auto& p : {std::array{x, 0.0, 0.0}, {x, -0.0, 0}, {x, 0, -0.0}, {x, -0.0, -0.0}}) points.push_back(p);
    for (const auto& p : {std::array{0.0, x, 0.0}, {-0.0, x, 0}, {0, x, -0.0}, {-0.0, x, -0.0}}) points.push_back(p);
  }
  const std::vector<int> first = mesh::same_places(points);
  for (int i = 0; i < static_cast<int>(first.size()); ++i) ASSERT_EQ(first[i], i - i % 4);
}

TEST(Build, PlacesThatAreNoNumbersAreNobodysEqual) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
  const mesh::Points points{{inf, 0, 0}, {1, 2, 3}, {inf, 0, 0}, {nan, 0, 0}, {1, 2, 3}, {nan, 0, 0}, {0, -inf, 0}};
  EXPECT_EQ(mesh::same_places(points), (std::vector<int>{0, 1, 2, 3, 1, 5, 6}));
}

TEST(Build, DropsWhatIsNoFace) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
  const mesh::Mesh mesh = mesh_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {nan, 0, 0}, {0, inf, 0}, {nan, 0, 0}},
                                  {{0, 1, 2},
                                   {1, 2, 0},        // the same, turned
                                   {2, 1, 0},        // the same, seen from behind
                                   {0, 0, 1},        // two corners
                                   {0, 1},           // two corners
                                   {},               // none
                                   {0, 1, 0, 1},     // two corners, four times
                                   {0, 1, 4},        // not finite
                                   {5, 1, 2},        // not finite
                                   {1, 3, 3, 2, 1},  // one triangle, stuttering
                                   {6, 6, 6}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 2);
  EXPECT_EQ(mesh.report.dropped_duplicates, 2);
  EXPECT_EQ(mesh.report.dropped_degenerate, 5);
  EXPECT_EQ(mesh.report.dropped_non_finite, 2);
  EXPECT_EQ(mesh.report.non_finite_vertices, 3);
  EXPECT_EQ(mesh.report.welded_vertices, 0);  // NaN is nobody's equal
  EXPECT_EQ(mesh.polygon, (std::vector<int>{0, 9}));
}

TEST(Build, PolygonsWithOneCornerSetInTwoOrdersAreTwoFaces) {
  const mesh::Points points{{0, 0, 0}, {1, 0, 0.5}, {1, 1, 0}, {0, 1, 0.5}};
  EXPECT_EQ(mesh_of(points, {{0, 1, 2, 3}, {2, 1, 0, 3}}).report.dropped_duplicates, 1);
  EXPECT_EQ(mesh_of(points, {{0, 1, 2, 3}, {0, 2, 1, 3}}).report.dropped_duplicates, 0);
}

TEST(Build, ATriangleWithoutAreaKeepsItsNeighboursClosed) {
  // The long edge 0-1 is split at 2 on one side only: the sliver 0 1 2 closes the gap.
  const mesh::Mesh mesh =
      mesh_of({{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, -1, 0}}, {{0, 2, 3}, {2, 1, 3}, {1, 0, 4}, {0, 1, 2}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 4);
  EXPECT_EQ(mesh.report.open_edges, 4);
  EXPECT_EQ(mesh.report.notes, (std::vector<std::string>{"1 triangle has no area"}));
  EXPECT_TRUE(mesh.report.remarks.empty());
}

TEST(Build, AFewTrianglesWithoutAreaAreRemarkedOnly) {
  // A strip of which one triangle of twelve has no area.
  mesh::Points points;
  std::vector<std::vector<int>> faces;
  for (int i = 0; i < 14; ++i) points.push_back({i < 2 ? 0.0 : i, i % 2 * 1.0, 0});
  points[2] = {0, 2, 0};
  for (int i = 0; i < 12; ++i) faces.push_back({i, i + 1, i + 2});
  const mesh::Mesh mesh = mesh_of(points, faces);
  EXPECT_TRUE(mesh.report.notes.empty());
  EXPECT_EQ(mesh.report.remarks, (std::vector<std::string>{"1 triangle has no area"}));
}

TEST(Build, ConcavePolygonsKeepTheirArea) {
  // An L, begun at each of its corners, seen from both sides and in three planes.
  const std::vector<std::array<double, 2>> outline{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (std::size_t start = 0; start < 6; ++start)
    for (const bool turned : {false, true})
      for (std::size_t axis = 0; axis < 3; ++axis) {
        mesh::Points points(6);
        for (std::size_t i = 0; i < 6; ++i) {
          points[i][(axis + 1) % 3] = outline[(start + i) % 6][0];
          points[i][(axis + 2) % 3] = outline[(start + i) % 6][1];
        }
        std::vector<int> face{0, 1, 2, 3, 4, 5};
        if (turned) std::reverse(face.begin(), face.end());
        const mesh::Mesh mesh = mesh_of(points, {face});
        expect_valid(mesh);
        ASSERT_EQ(mesh.report.triangles, 4);
        EXPECT_EQ(diagonals(mesh), 3);
        EXPECT_EQ(mesh.report.open_edges, 6);
        double sum = 0;
        for (int t = 0; t < 4; ++t) {
          const auto [a, b, c] = mesh.triangle(t);
          const Vec3 normal = glm::cross(mesh.point(b) - mesh.point(a), mesh.point(c) - mesh.point(a));
          EXPECT_GT(turned ? -normal[int(axis)] : normal[int(axis)], 0);
          sum += std::abs(normal[int(axis)]) / 2;
        }
        EXPECT_EQ(sum, 4.0);
      }
}

TEST(Build, PolygonWithAHoleOnABridge) {
  // A square of 4 x 4 with a hole of 2 x 2; the corners 0 and 4 are visited twice.
  const mesh::Mesh mesh =
      mesh_of({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}},
              {{0, 1, 2, 3, 0, 4, 5, 6, 7, 4}});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 8);
  EXPECT_EQ(mesh.report.open_edges, 8);
  double sum = 0;
  for (int t = 0; t < 8; ++t) {
    EXPECT_GT(area_z(mesh, t), 0);
    sum += area_z(mesh, t);
  }
  EXPECT_EQ(sum, 12.0);
}

TEST(Build, CornersOnALineMakeNoTriangleWithoutArea) {
  const mesh::Mesh mesh =
      mesh_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3, 4, 5}});
  ASSERT_EQ(mesh.report.triangles, 4);
  for (int t = 0; t < 4; ++t) EXPECT_GT(area_z(mesh, t), 0);
  EXPECT_TRUE(mesh.report.notes.empty());
}

TEST(Build, PolygonsOfAnySizeAndMagnitude) {
  for (const double scale : {1e-300, 1e-9, 1.0, 1e9, 1e307}) {
    // A star with 20 points: concave at every second corner.
    mesh::Points points;
    std::vector<int> face;
    for (int i = 0; i < 40; ++i) {
      const double r = scale * (i % 2 == 0 ? 2 : 1);
      points.push_back({r * std::cos(pi * i / 20), r * std::sin(pi * i / 20), 0});
      face.push_back(i);
    }
    const mesh::Mesh mesh = mesh_of(points, {face});
    expect_valid(mesh);
    ASSERT_EQ(mesh.report.triangles, 38);
    double sum = 0;
    for (int t = 0; t < 38; ++t) {
      const auto [a, b, c] = mesh.triangle(t);
      const Vec3 u = (mesh.point(b) - mesh.point(a)) / scale, v = (mesh.point(c) - mesh.point(a)) / scale;
      EXPECT_GT(glm::cross(u, v).z, 0);
      sum += glm::cross(u, v).z / 2;
    }
    EXPECT_NEAR(sum, 40 * std::sin(pi / 20), 1e-9);  // 40 triangles with sides 1 and 2
  }
}

// Ears lie between long teeth only, and each triangle's box is as high as a tooth.
TEST(Build, ALargeConcavePolygonHasNoFalseTriangle) {
  const int teeth = 20000;
  mesh::Points points{{-1, -1, 0}, {2.0 * teeth, -1, 0}};
  std::vector<int> face{0, 1};
  for (int i = 2 * teeth - 1; i >= 0; --i) {
    face.push_back(static_cast<int>(points.size()));
    points.push_back({1.0 * i, i % 2 == 0 ? 100.0 : 1.0, 0});
  }
  const mesh::Mesh mesh = mesh_of(points, {face});
  ASSERT_EQ(mesh.report.triangles, 2 * teeth);
  double sum = 0, twice = 0;
  for (int t = 0; t < mesh.report.triangles; ++t) {
    EXPECT_GT(area_z(mesh, t), 0);
    sum += area_z(mesh, t);
  }
  for (std::size_t i = 0; i < face.size(); ++i) {
    const auto& p = points[face[i]];
    const auto& q = points[face[(i + 1) % face.size()]];
    twice += p[0] * q[1] - p[1] * q[0];
  }
  EXPECT_EQ(sum, twice / 2);
}

TEST(Build, PolygonsThatCrossThemselvesKeepTheirCorners) {
  const mesh::Mesh bow_tie = mesh_of({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  expect_valid(bow_tie);
  EXPECT_EQ(bow_tie.report.triangles, 2);
  mesh::Points points;
  for (int i = 0; i < 5; ++i) points.push_back({std::cos(4 * pi * i / 5), std::sin(4 * pi * i / 5), 0});
  const mesh::Mesh pentagram = mesh_of(points, {{0, 1, 2, 3, 4}});
  expect_valid(pentagram);
  EXPECT_EQ(pentagram.report.triangles, 3);
}

TEST(Build, NamedBodiesAreNumberedByTheirFirstTriangle) {
  mesh::Soup soup = test::make_soup(test::unit_cube, test::cube_quads);
  soup.body_names = {"unused", "sides", "caps"};
  soup.face_body = {2, 2, 1, 1, 1, 1};
  const mesh::Mesh mesh = mesh::build_mesh(soup, "test");
  EXPECT_EQ(mesh.report.body_names, (std::vector<std::string>{"caps", "sides"}));
  EXPECT_EQ(mesh.body, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_EQ(mesh.report.bodies, 2);
}

TEST(Build, WiresEndAtTheVerticesThatFacesHave) {
  mesh::Soup soup = test::make_soup(test::unit_cube, test::cube_quads);
  const int end = static_cast<int>(soup.points.size());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  soup.points.insert(soup.points.end(), {soup.points[6], {5, 5, 5}, {nan, 0, 0}});
  soup.wires = {{end + 1, end}, {end, 6}, {end + 1, end + 2}, {0, 6}};
  const mesh::Mesh mesh = mesh::build_mesh(soup, "test");
  const std::array<int, 2> new_edge{6, end + 1}, through_the_cube{0, 6};
  for (const auto& wire : {new_edge, through_the_cube}) {
    ASSERT_NE(mesh.edge_between(wire), nullptr);
    EXPECT_EQ(mesh.edge_between(wire)->count, 0);
    EXPECT_TRUE(mesh.edge_between(wire)->wire);
  }
  EXPECT_EQ(mesh.report.wires, 2);
  EXPECT_EQ(mesh.report.open_edges, 0);
  EXPECT_EQ(mesh.report.notes, std::vector<std::string>{"1 piece of lines left out, whose coordinates are not finite"});
}

TEST(Build, NothingIsAMesh) {
  const mesh::Mesh mesh = mesh_of({}, {});
  expect_valid(mesh);
  EXPECT_EQ(mesh.report.triangles, 0);
}

}  // namespace
}  // namespace epura::build_test
