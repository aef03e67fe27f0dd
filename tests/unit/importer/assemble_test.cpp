// SPDX-License-Identifier: Apache-2.0
// Documents in memory become meshes and parts.
#include "importer/assemble.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/portable_math.hpp"
#include "errors.hpp"
#include "mesh/read.hpp"

namespace epura::test::assemble_test {
namespace {

using surfaces::SurfaceKind;

constexpr std::array<double, 12> as_it_is{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

void add_polygon(importer::Shape& shape, std::initializer_list<int> corners, int face) {
  shape.corners.insert(shape.corners.end(), corners);
  shape.polygon_ends.push_back(static_cast<int>(shape.corners.size()));
  shape.face_of_polygon.push_back(face);
  shape.body_of_polygon.push_back(-1);
}

/// A cylinder about z from 0 to `height`: side, lid and bottom are faces of the part, their rims its edges.
importer::Shape cylinder(double radius, double height, int steps) {
  importer::Shape shape{.name = "cylinder"};
  for (int end = 0; end < 2; ++end)
    for (int i = 0; i < steps; ++i) {
      const double angle = 2 * std::numbers::pi * i / steps;
      shape.points.push_back({radius * portable_cos(angle), radius * portable_sin(angle), end * height});
    }
  const auto polygon = [&](std::initializer_list<int> corners, int face) { add_polygon(shape, corners, face); };
  for (int i = 0; i < steps; ++i) {
    const int j = (i + 1) % steps;
    polygon({i, j, steps + j, steps + i}, 0);
    if (i > 0 && j > 0) polygon({0, j, i}, 1), polygon({steps, steps + i, steps + j}, 2);
  }
  shape.faces = {{SurfaceKind::cylinder, Vec3(0), {0, 0, 1}, radius, 0, 0},
                 {SurfaceKind::plane, Vec3(0), {0, 0, 1}, 0, 0, 0},
                 {SurfaceKind::plane, Vec3(0, 0, height), {0, 0, 1}, 0, 0, 0}};
  for (int end = 0; end < 2; ++end) {
    for (int i = 0; i <= steps; ++i) shape.edge_vertices.push_back(end * steps + i % steps);
    shape.edges.push_back({90, false, static_cast<int>(shape.edge_vertices.size())});
  }
  return shape;
}

/// A ring around such a cylinder, whose bore is divided as the cylinder's side: bore, outside, bottom and lid.
importer::Shape ring(double radius, double height, int steps) {
  importer::Shape shape = cylinder(radius, height, steps), outside = cylinder(2 * radius, height, steps);
  shape.name = "ring";
  shape.points.insert(shape.points.end(), outside.points.begin(), outside.points.end());
  shape.corners.clear(), shape.polygon_ends.clear(), shape.face_of_polygon.clear(), shape.body_of_polygon.clear();
  const auto polygon = [&](std::initializer_list<int> corners, int face) { add_polygon(shape, corners, face); };
  for (int i = 0; i < steps; ++i) {
    const int j = (i + 1) % steps, out = 2 * steps;
    polygon({j, i, steps + i, steps + j}, 0);
    polygon({out + i, out + j, out + steps + j, out + steps + i}, 1);
    polygon({i, j, out + j, out + i}, 2);
    polygon({steps + j, steps + i, out + steps + i, out + steps + j}, 3);
  }
  shape.faces.insert(shape.faces.begin() + 1, outside.faces[0]);
  return shape;
}

/// Divides the first face of a shape in halves, of which the second one is slightly wider: they are not joined.
void halve(importer::Shape& shape, int steps, double angle, bool is_tangent) {
  const int second = static_cast<int>(shape.faces.size());
  shape.faces.push_back(shape.faces[0]);
  shape.faces.back().radius *= 1.001;
  int polygons = 0;
  for (int& face : shape.face_of_polygon)
    if (face == 0 && ++polygons > steps / 2) face = second;
  for (const int i : {0, steps / 2}) {
    shape.edge_vertices.insert(shape.edge_vertices.end(), {i, steps + i});
    shape.edges.push_back({angle, is_tangent ? 1 : 0, static_cast<int>(shape.edge_vertices.size())});
  }
}

struct Read {
  mesh::Mesh mesh;
  surfaces::PartFaces part;
};

Read read(const importer::Document& document) {
  importer::Assembled assembled = importer::assemble(document, "test");
  mesh::Mesh mesh = mesh::make_mesh(std::move(assembled.soup), "test");
  surfaces::PartFaces part = surfaces::part_of(mesh, assembled.part, 5);
  return {std::move(mesh), std::move(part)};
}

TEST(DeclaredPart, HasFacesAndEdgesAsDeclared) {
  const Read r = read({.shapes = {cylinder(5, 20, 48)}});
  ASSERT_EQ(r.part.faces.size(), 3U);
  const surfaces::PartFace& side = r.part.faces[0];
  EXPECT_EQ(side.surface.kind, SurfaceKind::cylinder);
  EXPECT_FALSE(side.inwards);
  EXPECT_EQ(side.sweep, 360);
  EXPECT_EQ(side.from, 0);
  EXPECT_EQ(side.to, 20);
  EXPECT_EQ(side.triangles, 96);
  EXPECT_NEAR(side.area, 2 * 48 * 5 * std::sin(std::numbers::pi / 48) * 20, 1e-9);
  EXPECT_LT(side.residual, 1e-14);
  const double step = std::numbers::pi / 48;  // the middle of a triangle is a third of the way to its chord's middle
  EXPECT_NEAR(side.sagitta, 5 - 5 * std::hypot(std::cos(step), std::sin(step) / 3), 1e-12);
  // Planes face outwards, whichever way the file had them.
  EXPECT_EQ(r.part.faces[1].surface.axis, Vec3(0, 0, -1));
  EXPECT_EQ(r.part.faces[2].surface.axis, Vec3(0, 0, 1));
  ASSERT_EQ(r.part.borders.size(), 2U);
  for (const surfaces::PartBorder& border : r.part.borders) {
    EXPECT_EQ(border.kind, surfaces::BorderKind::sharp);
    EXPECT_EQ(border.angle, 90);
    EXPECT_EQ(border.edges.size(), 48U);
    EXPECT_EQ(border.faces[0], 0);
  }
  EXPECT_EQ(r.part.recognised, 1);
}

TEST(DeclaredPart, HalvesOfARoundFaceAreOne) {
  importer::Shape shape = cylinder(5, 20, 48);
  const int side = shape.face_of_polygon.front();
  const surfaces::PartSurface turned{SurfaceKind::cylinder, Vec3(0, 0, 7), {0, 0, -1}, 5, 0, 0};
  for (const double radius : {5.0, 5.001}) {
    shape.faces.resize(3);
    shape.faces.push_back(turned);
    shape.faces.back().radius = radius;
    int polygons_of_side = 0;
    for (int& face : shape.face_of_polygon)
      if ((face == side || face == 3) && ++polygons_of_side > 24) face = 3;
    const Read r = read({.shapes = {shape}});
    ASSERT_EQ(r.part.faces.size(), radius == 5 ? 3U : 4U);
    EXPECT_EQ(r.part.faces[0].sweep, radius == 5 ? 360 : 180);
    EXPECT_EQ(r.part.borders.size(), radius == 5 ? 2U : 3U) << "rims, and the edges between the halves";
  }
}

TEST(DeclaredPart, BordersThatAreNotDeclaredAreThoseOfTheFacets) {
  importer::Shape shape = cylinder(5, 20, 48);
  shape.edges.clear();
  shape.edge_vertices.clear();
  const Read r = read({.shapes = {shape}});
  ASSERT_EQ(r.part.borders.size(), 2U);
  EXPECT_NEAR(r.part.borders[0].angle, 90, 1e-9);
  EXPECT_EQ(r.part.borders[0].edges.size(), 48U);
}

TEST(DeclaredPart, TangentEdgesAreWithinTheLimitOrDeclared) {
  importer::Shape shape = cylinder(5, 20, 48);
  shape.edges[0].angle = 4.9;
  shape.edges[1].angle = 20;
  shape.edges[1].is_tangent = 1;
  const Read r = read({.shapes = {shape}});
  for (const surfaces::PartBorder& border : r.part.borders) EXPECT_EQ(border.kind, surfaces::BorderKind::tangent);
}

// Four triangles meet at each edge of the face at which two bodies touch.
TEST(DeclaredPart, BodiesThatTouchHaveNoBordersInsideTheirFaces) {
  const Read r = read({.shapes = {cylinder(5, 20, 48), ring(5, 20, 48)}});
  EXPECT_EQ(r.mesh.report.dropped_duplicates, 0);
  ASSERT_EQ(r.part.faces.size(), 7U);
  ASSERT_EQ(r.part.borders.size(), 4U) << "two rims of the cylinder and of the bore alike, two outside";
  for (const surfaces::PartBorder& border : r.part.borders) {
    EXPECT_EQ(border.kind, surfaces::BorderKind::sharp);
    EXPECT_NEAR(border.angle, 90, 1e-9);
    EXPECT_EQ(border.edges.size(), 48U);
  }
}

// Whether only one of the bodies has a border, or both.
TEST(DeclaredPart, TheSharpestBorderOfBodiesThatTouchCounts) {
  const auto border_inside = [](const importer::Shape& one, const importer::Shape& other) {
    const Read r = read({.shapes = {one, other}});
    EXPECT_EQ(r.part.borders.size(), 6U);
    std::vector<surfaces::PartBorder> inside;
    for (const surfaces::PartBorder& border : r.part.borders)
      if (border.edges.size() == 1) inside.push_back(border);
    EXPECT_EQ(inside.size(), 2U);
    for (const surfaces::PartBorder& border : inside) EXPECT_EQ(border.angle, inside.front().angle);
    return std::pair(inside.front().kind, inside.front().angle);
  };
  using surfaces::BorderKind;
  importer::Shape tangent = cylinder(5, 20, 48), sharp = ring(5, 20, 48);
  halve(tangent, 48, 0, true);
  EXPECT_EQ(border_inside(tangent, sharp), std::pair(BorderKind::tangent, 0.0));
  EXPECT_EQ(border_inside(sharp, tangent), std::pair(BorderKind::tangent, 0.0));
  halve(sharp, 48, 20, false);
  EXPECT_EQ(border_inside(tangent, sharp), std::pair(BorderKind::sharp, 20.0));
  EXPECT_EQ(border_inside(sharp, tangent), std::pair(BorderKind::sharp, 20.0));
}

TEST(Assembly, PutsInstancesDownMirroredTurnedAndScaled) {
  const std::array<double, 12> mirrored{-1, 0, 0, 100, 0, 1, 0, 0, 0, 0, 1, 0};
  const std::array<double, 12> twice{0, -2, 0, 0, 2, 0, 0, 0, 0, 0, 2, 50};
  const std::array<double, 12> stretched{1, 0, 0, 300, 0, 2, 0, 0, 0, 0, 1, 0};
  const Read r = read(
      {.shapes = {cylinder(5, 20, 48)},
       .nodes = {
           {-1, 0, "one", as_it_is}, {-1, -1, "group", mirrored}, {1, 0, "two", twice}, {-1, 0, "three", stretched}}});
  EXPECT_EQ(r.mesh.report.bodies, 3);
  EXPECT_EQ(r.mesh.report.body_names, (std::vector<std::string>{"one", "two", "three"}));
  EXPECT_EQ(r.mesh.report.open_edges, 0);
  EXPECT_EQ(r.mesh.report.misoriented_edges, 0);
  double volume = 0;
  for (int t = 0; t < r.mesh.triangle_count(); ++t) {
    const auto [a, b, c] = r.mesh.triangle(t);
    volume += glm::dot(r.mesh.point(a), glm::cross(r.mesh.point(b), r.mesh.point(c))) / 6;
  }
  // Mirrored ones have their outside outside, too.
  const double one = 48 * 0.5 * 25 * std::sin(2 * std::numbers::pi / 48) * 20;
  EXPECT_NEAR(volume, one * (1 + 8 + 2), 1e-7);
  ASSERT_EQ(r.part.faces.size(), 9U);
  EXPECT_EQ(r.part.faces[3].surface.kind, SurfaceKind::cylinder);
  EXPECT_NEAR(r.part.faces[3].surface.radius, 10, 1e-12);
  EXPECT_FALSE(r.part.faces[3].inwards);
  EXPECT_EQ(r.part.faces[6].surface.kind, SurfaceKind::free_form);
  EXPECT_EQ(r.part.borders.size(), 6U);
}

TEST(Assembly, PutsWiresDownWithTheirShapes) {
  importer::Shape shape = cylinder(5, 20, 8), lines{.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}};
  lines.wire_vertices = {0, 1, 2, 0, 2, 1};
  lines.wire_ends = {4, 6};
  const std::array<double, 12> mirrored{-1, 0, 0, 100, 0, 1, 0, 0, 0, 0, 1, 0};
  const Read r =
      read({.shapes = {shape, lines}, .nodes = {{-1, 0, "", as_it_is}, {-1, 1, "", as_it_is}, {-1, 1, "", mirrored}}});
  EXPECT_EQ(r.mesh.report.wires, 6);
  EXPECT_EQ(r.mesh.report.bodies, 1);
  for (const std::array<int, 2>& ends : {std::array{16, 17}, {17, 18}, {16, 18}, {19, 20}, {20, 21}, {19, 21}}) {
    ASSERT_NE(r.mesh.edge_between(ends), nullptr);
    EXPECT_TRUE(r.mesh.edge_between(ends)->wire);
  }
  EXPECT_EQ(r.mesh.point(21), Vec3(99, 1, 0));
  EXPECT_EQ(r.part.faces.size(), 3U) << "wires are of no face, which is no reason to recognise any";
  EXPECT_EQ(r.part.borders.size(), 2U);
  const Read alone = read({.shapes = {lines}});
  EXPECT_EQ(alone.mesh.report.triangles, 0);
  EXPECT_EQ(alone.mesh.report.wires, 3);
}

TEST(Assembly, NamesBodiesByNodeShapeAndBody) {
  importer::Shape two = cylinder(1, 1, 8);
  two.body_names = {"pin", "cap"};
  two.body_colours = {importer::no_colour, importer::no_colour};
  for (std::size_t i = 0; i < two.body_of_polygon.size(); ++i) two.body_of_polygon[i] = i < 4 ? 0 : 1;
  const importer::Assembled assembled =
      importer::assemble({.shapes = {two}, .nodes = {{-1, 0, "left", as_it_is}, {-1, 0, "", as_it_is}}}, "test");
  EXPECT_EQ(assembled.soup.body_names,
            (std::vector<std::string>{"left/pin", "left/cap", "cylinder/pin", "cylinder/cap"}));
  std::vector<std::pair<std::string, int>> parts;
  for (const importer::BodyPart& part : assembled.body_parts) parts.emplace_back(part.name, part.occurrence);
  EXPECT_EQ(parts, (std::vector<std::pair<std::string, int>>{
                       {"cylinder/pin", 0}, {"cylinder/cap", 0}, {"cylinder/pin", 1}, {"cylinder/cap", 1}}));
}

TEST(Assembly, ColoursOfNodesTakePrecedence) {
  importer::Shape two = cylinder(1, 1, 8);
  two.body_names = {"pin", "cap"};
  two.body_colours = {0x010203, importer::no_colour};
  for (std::size_t i = 0; i < two.body_of_polygon.size(); ++i) two.body_of_polygon[i] = i < 4 ? 0 : 1;
  const auto colours = [&](int of_shape, int of_root, int of_leaf) {
    two.colour = of_shape;
    return importer::assemble(
               {.shapes = {two}, .nodes = {{-1, -1, "root", as_it_is, of_root}, {0, 0, "leaf", as_it_is, of_leaf}}},
               "test")
        .soup.body_colours;
  };
  using Colours = std::vector<std::optional<Colour>>;
  constexpr int none = importer::no_colour, red = 0xff0000, green = 0x00ff00;
  EXPECT_EQ(colours(none, none, none), (Colours{Colour{1, 2, 3}, std::nullopt}));
  EXPECT_EQ(colours(red, none, none), (Colours{Colour{1, 2, 3}, Colour{255, 0, 0}}));
  EXPECT_EQ(colours(none, none, red), (Colours{Colour{255, 0, 0}, Colour{255, 0, 0}}));
  EXPECT_EQ(colours(none, green, red), (Colours{Colour{0, 255, 0}, Colour{0, 255, 0}}));
  two.body_colours = {none, none};
  EXPECT_TRUE(colours(none, none, none).empty());
}

TEST(Assembly, WithPolygonsOfNoFaceLeavesFacesToBeRecognised) {
  importer::Shape shape = cylinder(1, 1, 8);
  shape.face_of_polygon[3] = -1;
  const importer::Assembled assembled = importer::assemble({.shapes = {shape}}, "test");
  EXPECT_TRUE(assembled.part.faces.empty());
  EXPECT_EQ(assembled.soup.face_ends.size(), shape.polygon_ends.size());
}

// 4 triangles for a square of 6 corners, 2000 of which are a shape; copies add 20 million at most.
TEST(Assemble, CopiesAreBounded) {
  importer::Document document;
  importer::Shape& shape = document.shapes.emplace_back();
  for (int i = 0; i < 6; ++i) shape.points.push_back({std::cos(i), std::sin(i), 0});
  for (int i = 0; i < 2000; ++i) add_polygon(shape, {0, 1, 2, 3, 4, 5}, -1);
  document.nodes.assign(2502, {-1, 0, "", as_it_is});
  const Error error = error_of([&] { importer::assemble(document, "test"); });
  EXPECT_EQ(error.kind(), ErrorKind::input);
  EXPECT_STREQ(error.what(), "has more than 20 million triangles in copies of its parts");
  document.nodes.resize(100);
  EXPECT_EQ(importer::assemble(document, "test").soup.face_ends.size(), 200'000U);
}

}  // namespace
}  // namespace epura::test::assemble_test
