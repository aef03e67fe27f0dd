// SPDX-License-Identifier: Apache-2.0
#include "edges/feature_edges.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "shapes.hpp"

namespace epura::test::feature_edges_test {
namespace {

constexpr edges::EdgeOptions everything{.smooth = true};

using Kinds = std::map<std::string, int>;

// How many edges of each kind there are.
Kinds kinds(const world::World& world, const projection::Projection& projection,
            const edges::EdgeOptions& options = {}) {
  const view::ProjectedScene view = view::project_scene(world, projection, {});
  Kinds counts;
  for (const auto& kind : edges::feature_edges(world, view, 0, options))
    if (kind) ++counts[std::string(edges::name_of(*kind))];
  return counts;
}

const Vec3 corner(1.1, -2, 1.3);

// Three pages of 1 x 1 on a spine along z, the angles between them 120 degrees.
Shape fan_of_three() {
  Shape fan{{{0, 0, 0}, {0, 0, 1}}, {}, {}};
  for (int i = 0; i < 3; ++i) {
    const double a = (0.2 + i / 3.0) * 2 * std::numbers::pi;
    fan.points.push_back({std::cos(a), std::sin(a), 0});
    fan.points.push_back({std::cos(a), std::sin(a), 1});
    fan.faces.push_back({0, 2 * i + 2, 2 * i + 3, 1});
  }
  return fan;
}

TEST(FeatureEdges, OfACubeAreSixContoursAndSixCreases) {
  EXPECT_EQ(kinds(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic(corner)), (Kinds{{"contour", 6}, {"crease", 6}}));
  EXPECT_EQ(kinds(world_of(triangulated_cube()), orthographic(corner)), (Kinds{{"contour", 6}, {"crease", 6}}));
}

// A ridge along x whose edges, one after the other, are folded by these angles. Its sides share no other edges.
Shape ridge(const std::vector<double>& folds) {
  Shape shape{{{0, 0, 0}}, {}, {}};
  for (std::size_t i = 0; i < folds.size(); ++i) {
    const double x = double(i) + 0.5, drop = std::tan(folds[i] / 2 * std::numbers::pi / 180);
    const int at = int(shape.points.size());
    const int from = at == 1 ? 0 : at - 3;
    shape.points.push_back({x + 0.5, 0, 0});
    shape.points.push_back({x, 1, -drop});
    shape.points.push_back({x, -1, -drop});
    shape.faces.push_back({from, at, at + 1});
    shape.faces.push_back({at, from, at + 2});
  }
  return shape;
}

TEST(FeatureEdges, AWeakCreaseContinuesACrease) {
  const world::World world = world_of(ridge({25, 25, 40, 25, 15, 25}));
  const auto creases = [&](double weak) {
    return kinds(world, orthographic({0.1, 0.2, 1}), {.weak_angle = weak})["crease"];
  };
  EXPECT_EQ(creases(180), 1);
  EXPECT_EQ(creases(30), 1);
  EXPECT_EQ(creases(20), 4) << "the last one is beyond a gap";
  EXPECT_EQ(creases(10), 6);
  EXPECT_EQ(kinds(world_of(ridge({25, 25})), orthographic({0.1, 0.2, 1}), {.weak_angle = 20})["crease"], 0);
}

TEST(FeatureEdges, WiresAreDrawnUnlessFacesGiveAStrongerReason) {
  Shape cube = triangulated_cube();
  cube.points.push_back({3, 3, 3});
  const auto count = [&](const std::vector<std::array<int, 2>>& wires, const edges::EdgeOptions& options = {}) {
    Shape with_wires = cube;
    with_wires.wires = wires;
    return kinds(world_of(with_wires), orthographic(corner), options);
  };
  const Kinds alone{{"contour", 6}, {"crease", 6}}, with_one{{"contour", 6}, {"crease", 6}, {"wire", 1}};
  const mesh::Mesh mesh = mesh_of(cube);
  for (const mesh::MeshEdge& edge : mesh.edges) {
    const Vec3 along = mesh.point(edge.vertex[1]) - mesh.point(edge.vertex[0]);
    const bool inside_a_face = glm::dot(along, along) > 1.5;
    EXPECT_EQ(count({edge.vertex}), inside_a_face ? with_one : alone);
    if (inside_a_face) {
      EXPECT_EQ(count({edge.vertex}, everything), (Kinds{{"contour", 6}, {"crease", 6}, {"smooth", 5}, {"wire", 1}}));
    }
  }
  EXPECT_EQ(count({{0, 8}}), with_one);
  EXPECT_EQ(count({{0, 8}}, {.wire = false}), alone);
}

TEST(FeatureEdges, FaceOnTheBordersOfACubeAreContours) {
  // Four faces are seen edge-on: their upright edges are points on the page, and their diagonals are nothing.
  EXPECT_EQ(kinds(world_of(box({0, 0, 0}, {1, 1, 1})), from_above()), (Kinds{{"contour", 8}, {"crease", 4}}));
}

TEST(FeatureEdges, OnTheLineOfTheirEdgeTrianglesTurnByTheirOtherSides) {
  // A steep sheet hangs over an edge of length 10 and stands on it. Both apexes are nearer to its line on the page than
  // rounding of the file tells, but far from the triangles' short sides: what is in front there is in front here.
  constexpr double r = 1e-6;
  for (const double lower : {0.8 * r, -0.8 * r}) {
    world::World world =
        world_of({{{0, 0, 0}, {10, 0, 0}, {0.3, lower, -3}, {9.7, 0.8 * r, 3}}, {{0, 1, 2}, {1, 0, 3}}, {}});
    world.rounding = r;
    EXPECT_EQ(kinds(world, from_above(), {.boundary = false})["contour"], lower > 0 ? 1 : 0) << lower;
  }
}

TEST(FeatureEdges, DiagonalsAreSmoothButNotInsideAPolygon) {
  EXPECT_EQ(kinds(world_of(triangulated_cube()), orthographic(corner), everything)["smooth"], 6);
  EXPECT_EQ(kinds(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic(corner), everything)["smooth"], 0);
}

TEST(FeatureEdges, AnOpenBoxHasABoundary) {
  Shape open = box({0, 0, 0}, {1, 1, 1});
  open.faces.erase(open.faces.begin() + 1);  // z = 1
  // Of the eight other edges four bound the three faces that turn the other way.
  EXPECT_EQ(kinds(world_of(open), orthographic(corner)), (Kinds{{"boundary", 4}, {"contour", 4}, {"crease", 4}}));
}

TEST(FeatureEdges, WhereThreeFacesMeetIsACrease) {
  EXPECT_EQ(kinds(world_of(fan_of_three()), orthographic(corner)), (Kinds{{"boundary", 9}, {"crease", 1}}));
}

// Two boxes that touch in the edge x = y = 1, as named groups of one file.
world::World touching_boxes(const std::vector<std::string>& names) {
  Shape boxes = box({0, 0, 0}, {1, 1, 1});
  boxes.add(box({1, 1, 0}, {2, 2, 1}));
  mesh::Soup soup;
  soup.points = boxes.points;
  soup.body_names = names;
  for (std::size_t f = 0; f < boxes.faces.size(); ++f) {
    soup.corners.insert(soup.corners.end(), boxes.faces[f].begin(), boxes.faces[f].end());
    soup.end_face();
    soup.face_body.push_back(f < 6 ? 0 : static_cast<int>(names.size()) - 1);
  }
  return world::make_world(
      {{std::make_shared<const mesh::Mesh>(mesh::build_mesh(std::move(soup), "boxes")), Mat4(1.0)}});
}

TEST(FeatureEdges, BodiesThatTouchInAnEdgeAreJudgedEachByItself) {
  // The common edge is a contour of both boxes, whether they have names or not.
  const projection::Projection view = orthographic({1, -3, 0.5});
  EXPECT_EQ(kinds(touching_boxes({"a", "b"}), view), (Kinds{{"contour", 11}, {"crease", 12}}));
  EXPECT_EQ(kinds(touching_boxes({"a"}), view), (Kinds{{"contour", 11}, {"crease", 12}}));
}

TEST(FeatureEdges, OrientationChangesNothing) {
  Shape cube = triangulated_cube();
  for (std::size_t f = 0; f < cube.faces.size(); f += 2) std::swap(cube.faces[f][0], cube.faces[f][2]);
  EXPECT_EQ(kinds(world_of(cube), orthographic(corner), everything),
            (Kinds{{"contour", 6}, {"crease", 6}, {"smooth", 6}}));
}

TEST(FeatureEdges, OnlyWishedKindsAreNamed) {
  const world::World world = world_of(fan_of_three());
  EXPECT_EQ(kinds(world, orthographic(corner), {.boundary = false}), (Kinds{{"crease", 1}}));
  EXPECT_EQ(kinds(world, orthographic(corner), {.crease = false}), (Kinds{{"boundary", 9}}));
  // A contour that nobody wants as such is still a crease.
  EXPECT_EQ(kinds(world_of(box({0, 0, 0}, {1, 1, 1})), orthographic(corner), {.contour = false}),
            (Kinds{{"crease", 12}}));
}

TEST(FeatureEdges, TheCreaseAngleIsTheAngleBetweenTheFaces) {
  const auto roof = [](double degrees) {
    const double a = degrees / 2 * std::numbers::pi / 180;
    return Shape{{{0, 0, 0},
                  {0, 1, 0},
                  {-std::cos(a), 0, -std::sin(a)},
                  {-std::cos(a), 1, -std::sin(a)},
                  {std::cos(a), 0, -std::sin(a)},
                  {std::cos(a), 1, -std::sin(a)}},
                 {{0, 1, 3, 2}, {0, 4, 5, 1}},
                 {}};
  };
  for (const double degrees : {1.0, 30.0, 60.0, 90.0}) {
    const world::World world = world_of(roof(degrees));
    EXPECT_EQ(kinds(world, from_above(), {.crease_angle = degrees})["crease"], 1) << degrees;
    EXPECT_EQ(kinds(world, from_above(), {.crease_angle = degrees + 0.01})["crease"], 0) << degrees;
  }
}

TEST(FeatureEdges, ASliverInARidgeLeavesOneRidge) {
  // A roof whose ridge is split on one side only; the gap is filled by a triangle without height.
  for (const double height : {0.0, 1e-14}) {
    const Shape roof{{{0, 0, 0}, {0, 2, 0}, {-1, 0, -1}, {-1, 2, -1}, {1, 0, -1}, {1, 2, -1}, {0, 1, -height}},
                     {{0, 1, 3, 2}, {0, 6, 1}, {0, 4, 6}, {4, 5, 6}, {5, 1, 6}},
                     {}};
    double length = 0;
    const Result result = draw(world_of(roof), from_above(), {.boundary = false});
    for (const drawing::Segment& s : result.drawing.segments) length += glm::length(s.to - s.from) * result.unit;
    EXPECT_NEAR(length, 2, 1e-9) << height;
  }
}

// A square whose one half needs a needle that is folded over in its plane: corner 4 lies before the diagonal 1, 3.
Shape pleated_square(double overlap) {
  return {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {3.6 - overlap, 0.4 - overlap, 0}},
          {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {4, 2, 3}},
          {}};
}

TEST(FeatureEdges, ANeedleFoldedOverInItsPlaneIsNoLine) {
  for (const double overlap : {0.1, 1e-3, 1e-6, 1e-9})
    for (const projection::Projection& view : {from_above(), orthographic(corner)})
      EXPECT_EQ(kinds(world_of(pleated_square(overlap)), view), (Kinds{{"boundary", 4}})) << overlap;
}

TEST(FeatureEdges, ANeedleFoldedOverBesideItsPlaneByRoundingIsNoLine) {
  Shape square = pleated_square(0.1);
  square.points[4][2] = 1e-11;
  EXPECT_EQ(kinds(world_of(square), from_above()), (Kinds{{"boundary", 4}}));
  square.points[4][2] = 1e-3;
  EXPECT_GT(kinds(world_of(square), from_above()).count("contour"), 0U);
}

// Where the surface does not fold back at the third side of the needle, but bends down there, the needle sticks out.
TEST(FeatureEdges, ANeedleThatSticksOutHasAnOutline) {
  Shape square = pleated_square(0.1);
  square.points.push_back({4, 4, -3});
  square.faces[3] = {4, 5, 3};
  const Kinds found = kinds(world_of(square), from_above());
  EXPECT_GE(found.contains("contour") ? found.at("contour") : 0, 1);
  EXPECT_EQ(kinds(world_of(pleated_square(0.1)), from_above()).count("contour"), 0U);
}

TEST(FeatureEdges, ASheetOfTwoLayersHasAnOutline) {
  const Shape sheet{{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, {}};
  EXPECT_EQ(kinds(world_of(sheet), from_above()), (Kinds{{"contour", 4}}));
}

TEST(FeatureEdges, BetweenBentPolygonsAreFoldsOfTheirMeanPlanes) {
  // Two hexagons in one plane, but for the corners beside their common side: the triangles there fold by 53 degrees.
  const Shape bent{{{0, 0, 0},
                    {0, 1, 0},
                    {-1, -1, 0.5},
                    {-2, -1, 0},
                    {-2, 2, 0},
                    {-1, 2, 0.5},
                    {1, 2, 0.5},
                    {2, 2, 0},
                    {2, -1, 0},
                    {1, -1, 0.5}},
                   {{0, 1, 5, 4, 3, 2}, {1, 0, 9, 8, 7, 6}},
                   {}};
  EXPECT_EQ(kinds(world_of(bent), from_above(), {.contour = false, .boundary = false}), Kinds{});
  EXPECT_EQ(kinds(world_of(bent), from_above(), {.contour = false, .boundary = false, .crease_angle = 10}),
            (Kinds{{"crease", 1}}));
}

TEST(FeatureEdges, APolygonThatNamesACornerTwiceHasNoDiagonals) {
  const Shape loops{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {6, 4, 0}, {6, 6, 0}}, {{0, 1, 2, 4, 5, 2, 3}}, {}};
  EXPECT_EQ(kinds(world_of(loops), from_above()), (Kinds{{"boundary", 7}}));
  const Shape spike{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 1, 2, 1, 3}}, {}};
  EXPECT_EQ(kinds(world_of(spike), from_above()), (Kinds{{"boundary", 3}}));
}

// A polygon in a tilted plane, its outline a circle with 40 waves.
Shape wavy_face(int corners) {
  Shape face;
  face.faces.emplace_back();
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, radius = 50 + 5 * std::sin(40 * angle);
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    face.points.push_back({x, y, 0.3 * x + 0.7 * y});
    face.faces.back().push_back(i);
  }
  return face;
}

TEST(FeatureEdges, AFlatFaceOfVeryManyCornersHasItsBoundaryOnly) {
  // Its ears are thinner than the page grid, so that corners of neighbours may seem to lie on one side.
  constexpr int corners = 30000;
  EXPECT_EQ(kinds(world_of(wavy_face(corners)), orthographic(corner)), (Kinds{{"boundary", corners}}));
}

TEST(FeatureEdges, BehindTheEyeSidesAreFoundWithoutDivision) {
  // The eye stands in a long box: the edges along the view run past it.
  const world::World world = world_of(box({-1, -5, -1}, {1, 5, 1}));
  const projection::Projection p = perspective({0, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1});
  // From within every face turns inward alike: no contours.
  EXPECT_EQ(kinds(world, p), (Kinds{{"crease", 12}}));
}

}  // namespace
}  // namespace epura::test::feature_edges_test
