// SPDX-License-Identifier: Apache-2.0
#include "mesh/bodies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "shapes.hpp"
#include "support.hpp"

namespace epura::test::bodies_test {
namespace {

using Cell = std::array<int, 3>;

Shape welded(const std::vector<Shape>& parts) {
  Shape all;
  for (const Shape& part : parts) all.add(part);
  std::map<Point, int> number;
  Shape one;
  for (const auto& face : all.faces) {
    std::vector<int> ring;
    for (const int v : face) {
      const auto [found, made] = number.try_emplace(all.points[v], static_cast<int>(one.points.size()));
      if (made) one.points.push_back(all.points[v]);
      ring.push_back(found->second);
    }
    one.faces.push_back(ring);
  }
  return one;
}

Shape inside_out(Shape shape) {
  for (auto& face : shape.faces) std::reverse(face.begin(), face.end());
  return shape;
}

Shape turned(Shape shape, bool single_precision) {
  const Mat4 turn = glm::rotate(Mat4(1), 0.7, Vec3(0.2, -0.6, 0.77));
  for (Point& p : shape.points) {
    const Vec3 q(turn * Vec4(p[0] + 3, p[1] - 5, p[2], 1));
    for (int i = 0; i < 3; ++i) p[i] = single_precision ? static_cast<double>(static_cast<float>(q[i])) : q[i];
  }
  return shape;
}

Shape triangulated(const Shape& shape) {
  Shape triangles;
  triangles.points = shape.points;
  for (const auto& face : shape.faces) {
    // From the lowest corner, so that faces with the same corners are divided alike.
    auto ring = face;
    std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
    for (std::size_t i = 2; i < ring.size(); ++i) triangles.faces.push_back({ring[0], ring[i - 1], ring[i]});
  }
  return triangles;
}

mesh::Mesh built(const Shape& shape, bool single_precision = false) {
  mesh::Soup soup = make_soup(shape.points, shape.faces);
  soup.single_precision = single_precision;
  return mesh::build_mesh(std::move(soup), "test");
}

// Bodies as sets of the boxes around them do not depend on how things are numbered.
std::multiset<std::array<double, 6>> boxes(const mesh::Mesh& mesh) {
  std::vector<Box> box(static_cast<std::size_t>(mesh.report.bodies));
  for (int t = 0; t < mesh.triangle_count(); ++t)
    for (const int v : mesh.triangle(t)) box[mesh.body[t]].add(mesh.point(v));
  std::multiset<std::array<double, 6>> all;
  for (const Box& b : box) all.insert({b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z});
  return all;
}

Shape shuffled(const Shape& shape, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<int> place(shape.points.size());
  std::iota(place.begin(), place.end(), 0);
  std::shuffle(place.begin(), place.end(), random);
  Shape other;
  other.points.resize(shape.points.size());
  for (std::size_t v = 0; v < place.size(); ++v) other.points[place[v]] = shape.points[v];
  for (auto face : shape.faces) {
    for (int& v : face) v = place[v];
    std::rotate(face.begin(), face.begin() + static_cast<int>(random() % face.size()), face.end());
    other.faces.push_back(face);
  }
  std::shuffle(other.faces.begin(), other.faces.end(), random);
  return other;
}

Shape partly_reversed(Shape shape, unsigned seed) {
  std::mt19937 random(seed);
  for (auto& face : shape.faces)
    if (random() % 2 == 0) std::reverse(face.begin(), face.end());
  return shape;
}

Shape cubes_at_an_edge() { return welded({box({0, 0, 0}, {1, 1, 1}), box({1, 1, 0}, {2, 2, 1})}); }

// An angle of profile with its inner edge at x = z = 1, and a cube that fills the corner in part.
Shape cube_in_a_corner() {
  const std::vector<std::array<double, 2>> profile{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
  Shape angle;
  for (const double y : {0.0, 2.0})
    for (const auto& [x, z] : profile) angle.points.push_back({x, y, z});
  std::vector<int> front, back;
  for (int i = 0; i < 6; ++i) {
    front.push_back(i);
    back.push_back(11 - i);
    angle.faces.push_back({(i + 1) % 6, i, 6 + i, 6 + (i + 1) % 6});
  }
  angle.faces.push_back(front);
  angle.faces.push_back(back);
  return welded({angle, box({1, 0, 1}, {2, 2, 2})});
}

TEST(Bodies, CubesThatShareAnEdgeAreTwo) {
  const Shape cubes = cubes_at_an_edge();
  ASSERT_EQ(cubes.points.size(), 14u);
  const mesh::Mesh mesh = built(cubes);
  EXPECT_EQ(mesh.report.bodies, 2);
  EXPECT_EQ(mesh.report.non_manifold_edges, 0);
  for (unsigned seed = 0; seed < 20; ++seed) EXPECT_EQ(boxes(built(shuffled(cubes, seed))), boxes(mesh)) << seed;
  EXPECT_EQ(built(inside_out(cubes)).report.bodies, 2);
  for (unsigned seed = 0; seed < 20; ++seed) EXPECT_EQ(built(partly_reversed(cubes, seed)).report.bodies, 2) << seed;
  for (const double scale : {1e-150, 1e140}) EXPECT_EQ(built(cubes.scaled(scale)).report.bodies, 2);
}

TEST(Bodies, OneThatFillsTheCornerOfAnotherIsItsOwn) {
  const Shape both = cube_in_a_corner();
  ASSERT_EQ(both.points.size(), 18u);  // two in common
  for (const bool single : {false, true})
    for (unsigned seed = 0; seed < 20; ++seed) {
      const Shape some = partly_reversed(shuffled(single ? turned(both, true) : both, seed), seed);
      EXPECT_EQ(built(some, single).report.bodies, 2) << single << " " << seed;
    }
  EXPECT_EQ(built(turned(both, false)).report.bodies, 2);
}

// A shaft in a bearing, which touches it all around: the faces between them are a closed band of their own, twice, and
// share no edge with two faces alone. Their quadrangles are divided differently.
TEST(Bodies, OneInARingIsItsOwn) {
  constexpr int corners = 12;
  const auto ring_at = [](Shape& shape, double radius, double z) {
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      shape.points.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  };
  const auto strip = [](Shape& shape, int low, int high) {
    for (int i = 0; i < corners; ++i) {
      const int j = (i + 1) % corners, a = low * corners, b = high * corners;
      shape.faces.push_back({a + i, a + j, b + j});
      shape.faces.push_back({a + i, b + j, b + i});
    }
  };
  Shape bearing, shaft;
  for (const auto& [radius, z] : {std::pair(8.0, 0.0), {15.0, 0.0}, {15.0, 12.0}, {8.0, 12.0}})
    ring_at(bearing, radius, z);
  for (int i = 0; i < 4; ++i) strip(bearing, i, (i + 1) % 4);
  for (const double z : {-10.0, 0.0, 12.0, 25.0}) ring_at(shaft, 8, z);
  for (int i = 0; i < 3; ++i) strip(shaft, i, i + 1);
  std::vector<int> bottom, top;
  for (int i = 0; i < corners; ++i) {
    bottom.insert(bottom.begin(), i);
    top.push_back(3 * corners + i);
  }
  shaft.faces.push_back(bottom);
  shaft.faces.push_back(top);
  for (const Shape& pair : {welded({bearing, shaft}), shuffled(welded({bearing, shaft}), 3)}) {
    const mesh::Mesh mesh = built(pair);
    EXPECT_EQ(mesh.report.dropped_duplicates, 0);
    EXPECT_EQ(mesh.report.bodies, 2);
  }
}

// The sides of a sheet in the plane y = 1, from x = 0 to 1.
Shape sheet_of_two_sides(double z) {
  Shape sheet;
  sheet.points = {{0, 1, z}, {1, 1, z}, {1, 1, z + 1}, {0, 1, z + 1}};
  sheet.faces = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};
  return sheet;
}

// Each body has the face at which they touch, divided alike.
TEST(Bodies, ThatHaveAFaceInCommonAreTwo) {
  const Shape left = box({0, 0, 0}, {1, 1, 1}), right = box({1, 0, 0}, {3, 1, 1});
  const std::multiset<std::array<double, 6>> both{{0, 0, 0, 1, 1, 1}, {1, 0, 0, 3, 1, 1}};
  for (const Shape& pair : {welded({left, right}), welded({right, left}), inside_out(welded({left, right})),
                            welded({left, inside_out(right)}), welded({inside_out(left), right})})
    for (const Shape& shape :
         {pair, shuffled(pair, 1), shuffled(pair, 2), triangulated(pair), triangulated(shuffled(pair, 3))}) {
      const mesh::Mesh mesh = built(shape);
      EXPECT_EQ(mesh.report.dropped_duplicates, 0);
      EXPECT_EQ(mesh.report.non_manifold_edges, 0);
      EXPECT_EQ(mesh.report.faces, static_cast<int>(shape.faces.size()));
      EXPECT_EQ(boxes(mesh), both);
    }
}

// A crack is closed only after faces have been compared.
TEST(Bodies, WithAFaceInCommonStayTwoIfAnotherHasACrack) {
  Shape all = welded({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {3, 1, 1}), box({5, 0, 0}, {6, 1, 1})});
  Point beside = all.points[all.faces.back()[0]];
  beside[0] = std::nextafter(beside[0], 9);
  all.faces.back()[0] = static_cast<int>(all.points.size());
  all.points.push_back(beside);
  for (const Shape& shape : {all, triangulated(all)}) {
    const mesh::Mesh mesh = built(shape);
    EXPECT_EQ(mesh.report.welded_vertices, 1);
    EXPECT_EQ(mesh.report.dropped_duplicates, 0);
    EXPECT_EQ(mesh.report.bodies, 3);
  }
}

// The inner ones have no face that is theirs alone.
TEST(Bodies, ThatTouchOnAllSidesAreOnesOfTheirOwn) {
  std::vector<Shape> cubes;
  for (int x = 0; x < 3; ++x)
    for (int y = 0; y < 3; ++y)
      for (int z = 0; z < 3; ++z) cubes.push_back(box({1. * x, 1. * y, 1. * z}, {x + 1., y + 1., z + 1.}));
  std::multiset<std::array<double, 6>> all;
  for (const Shape& cube : cubes) all.merge(std::multiset(boxes(built(cube))));
  for (const unsigned seed : {0U, 1U, 2U}) {
    const mesh::Mesh mesh = built(shuffled(welded(cubes), seed));
    EXPECT_EQ(mesh.report.dropped_duplicates, 0);
    EXPECT_EQ(boxes(mesh), all);
  }
}

TEST(Bodies, DuplicatesAreNone) {
  const Shape cube = box({0, 0, 0}, {1, 1, 1}), next = box({1, 0, 0}, {2, 1, 1});
  const auto expect = [](const Shape& shape, int bodies, int dropped) {
    for (const unsigned seed : {0U, 1U, 2U}) {
      const mesh::Mesh mesh = built(shuffled(shape, seed));
      EXPECT_EQ(mesh.report.bodies, bodies);
      EXPECT_EQ(mesh.report.dropped_duplicates, dropped);
    }
  };
  expect(sheet_of_two_sides(0), 1, 2);
  expect(welded({cube, cube}), 1, 6);
  expect(welded({cube, inside_out(cube)}), 1, 6);
  expect(welded({cube, sheet_of_two_sides(1)}), 1, 2);  // a fin on an edge
  const Shape corner = box({1, 1, 1}, {2, 2, 2});       // has one vertex in common with the cube, which is there once
  expect(welded({cube, corner, corner}), 2, 6);
  expect(welded({cube, corner, inside_out(corner)}), 2, 6);
  const Shape both = welded({cube, next});
  expect(welded({both, both}), 2, 12);
}

// A named body is a duplicate, too, even if some of its faces are missing; whichever comes first, the whole one stays.
TEST(Bodies, AnIncompleteCopyIsADuplicate) {
  const Shape cube = box({0, 0, 0}, {1, 1, 1});
  for (const Shape& copy : {cube, inside_out(cube)})
    for (const bool whole_first : {true, false}) {
      Shape part = copy;
      part.faces.pop_back();
      const Shape both = whole_first ? welded({cube, part}) : welded({part, cube});
      mesh::Soup soup = make_soup(both.points, both.faces);
      soup.body_names = {"front", "back"};
      soup.face_body.assign(whole_first ? 6 : 5, 0);
      soup.face_body.resize(both.faces.size(), 1);
      const mesh::Mesh mesh = mesh::build_mesh(std::move(soup), "test");
      EXPECT_EQ(mesh.report.dropped_duplicates, 5);
      EXPECT_EQ(mesh.report.bodies, 1);
      EXPECT_EQ(mesh.report.open_edges, 0);
    }
}

// The names decide, whatever the faces are.
TEST(Bodies, NamedOnesWithAFaceInCommonHaveItBoth) {
  for (const bool triangles : {false, true}) {
    Shape both = welded({box({0, 0, 0}, {1, 1, 1}), box({1, 0, 0}, {2, 1, 1})});
    if (triangles) both = triangulated(both);
    mesh::Soup soup = make_soup(both.points, both.faces);
    soup.body_names = {"left", "right"};
    soup.face_body.assign(both.faces.size() / 2, 0);
    soup.face_body.resize(both.faces.size(), 1);
    const mesh::Mesh mesh = mesh::build_mesh(std::move(soup), "test");
    EXPECT_EQ(mesh.report.dropped_duplicates, 0);
    const std::multiset<std::array<double, 6>> expected{{0, 0, 0, 1, 1, 1}, {1, 0, 0, 2, 1, 1}};
    EXPECT_EQ(boxes(mesh), expected);
  }
}

TEST(Bodies, CavitiesThatShareAnEdgeAreTwo) {
  const Shape cavities = inside_out(cubes_at_an_edge());
  EXPECT_EQ(built(welded({box({-1, -1, -1}, {3, 3, 3}), cavities})).report.bodies, 3);
}

TEST(Bodies, WhatContradictsItselfStaysOne) {
  // Sheets that cross.
  Shape sheets;
  for (const double y : {0.0, 1.0})
    for (const auto& [x, z] : {std::array{0., 0.}, {1., 0.}, {0., 1.}, {-1., 0.}, {0., -1.}})
      sheets.points.push_back({x, y, z});
  for (const int i : {1, 2, 3, 4})
    sheets.faces.push_back(i < 3 ? std::vector<int>{0, i, 5 + i, 5} : std::vector<int>{i, 0, 5, 5 + i});
  EXPECT_EQ(built(sheets).report.bodies, 1);
  EXPECT_EQ(built(klein_bottle(16, 12)).report.bodies, 1);
}

TEST(Bodies, NamedOnesStay) {
  Shape cubes = cubes_at_an_edge();
  mesh::Soup soup = make_soup(cubes.points, cubes.faces);
  soup.body_names = {"left and more", "rest"};
  soup.face_body.assign(12, 0);
  soup.face_body[11] = 1;
  const mesh::Mesh mesh = mesh::build_mesh(std::move(soup), "test");
  for (int t = 0; t < mesh.triangle_count(); ++t) EXPECT_EQ(mesh.body[t], mesh.polygon[t] == 11 ? 1 : 0) << t;
}

constexpr int room = 5;  // cells a side; those at the border are empty

class Cells {
 public:
  explicit Cells(unsigned seed) {
    std::mt19937 random(seed);
    for (int& cell : full_) cell = 0;
    for (int x = 1; x + 1 < room; ++x)
      for (int y = 1; y + 1 < room; ++y)
        for (int z = 1; z + 1 < room; ++z) full_[number({x, y, z})] = random() % 2;
  }

  // The faces between full and empty cells.
  [[nodiscard]] Shape surface() const {
    std::vector<Shape> quads;
    visit([&](const Cell& cell, const Cell& step) {
      const Shape cube = box({1. * cell[0], 1. * cell[1], 1. * cell[2]}, {cell[0] + 1., cell[1] + 1., cell[2] + 1.});
      for (const auto& face : cube.faces) {
        Vec3 middle(0);
        for (const int v : face) middle += Vec3(cube.points[v][0], cube.points[v][1], cube.points[v][2]) / 4.0;
        const Vec3 out = middle - Vec3(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5);
        if (glm::dot(out, Vec3(step[0], step[1], step[2])) < 0.4) continue;
        Shape quad;
        for (const int v : face) quad.points.push_back(cube.points[v]);
        quad.faces.push_back({0, 1, 2, 3});
        quads.push_back(quad);
      }
    });
    return welded(quads);
  }

  // A shell lies between full cells that are connected through faces and empty ones that are through faces and edges
  // (Herman, Geometry of Digital Spaces, 1998).
  [[nodiscard]] int shells() const {
    const std::vector<int> full = flooded(1, 1), empty = flooded(0, 2);
    std::set<std::array<int, 2>> pairs;
    visit([&](const Cell& cell, const Cell& step) {
      pairs.insert({full[number(cell)], empty[number({cell[0] + step[0], cell[1] + step[1], cell[2] + step[2]})]});
    });
    return static_cast<int>(pairs.size());
  }

 private:
  static int number(const Cell& c) { return (c[0] * room + c[1]) * room + c[2]; }

  template <class Visit>
  void visit(const Visit& face) const {
    for (int x = 1; x + 1 < room; ++x)
      for (int y = 1; y + 1 < room; ++y)
        for (int z = 1; z + 1 < room; ++z)
          for (const Cell& step : {Cell{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}})
            if (full_[number({x, y, z})] == 1 && full_[number({x + step[0], y + step[1], z + step[2]})] == 0)
              face({x, y, z}, step);
  }

  [[nodiscard]] std::vector<int> flooded(int kind, int farthest) const {
    std::vector<int> label(full_.size(), -1);
    for (int seed = 0; seed < static_cast<int>(full_.size()); ++seed) {
      if (full_[seed] != kind || label[seed] >= 0) continue;
      std::vector<int> next{seed};
      label[seed] = seed;
      while (!next.empty()) {
        const int at = next.back();
        next.pop_back();
        for (int other = 0; other < static_cast<int>(full_.size()); ++other) {
          const int dx = at / room / room - other / room / room, dy = at / room % room - other / room % room,
                    dz = at % room - other % room;
          if (full_[other] != kind || label[other] >= 0 || std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) > 1 ||
              std::abs(dx) + std::abs(dy) + std::abs(dz) > farthest)
            continue;
          label[other] = seed;
          next.push_back(other);
        }
      }
    }
    return label;
  }

  std::array<int, room * room * room> full_;
};

TEST(Bodies, AreTheShellsOfRandomCells) {
  int with_touching = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Cells cells(seed);
    const Shape surface = cells.surface();
    for (const Shape& some :
         {surface, shuffled(surface, seed), turned(surface, false), partly_reversed(surface, seed)}) {
      const mesh::Mesh mesh = built(some);
      ASSERT_EQ(mesh.report.bodies, cells.shells()) << seed;
      with_touching += std::any_of(mesh.edges.begin(), mesh.edges.end(), [&](const mesh::MeshEdge& edge) {
        const auto triangles = mesh.triangles_of(edge);
        return std::any_of(triangles.begin(), triangles.end(),
                           [&](int t) { return mesh.body[t] != mesh.body[triangles[0]]; });
      });
    }
  }
  EXPECT_GT(with_touching, 200);
}

// From the z axis to a distance of 1, between two angles.
Shape wedge(double from, double to) {
  Shape shape;
  for (const double z : {0.0, 1.0})
    shape.points.insert(shape.points.end(),
                        {{0, 0, z}, {std::cos(from), std::sin(from), z}, {std::cos(to), std::sin(to), z}});
  shape.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  return shape;
}

// Material begins twice before it ends: which faces belong together is uncertain, so that all of them do.
TEST(Bodies, ThatOverlapAtAnEdgeAreJoinedWithAllThatTouchThere) {
  EXPECT_EQ(built(welded({wedge(0, 1.5), wedge(2, 2.5), wedge(3.5, 4.5)})).report.bodies, 3);
  EXPECT_EQ(built(welded({wedge(0, 1.5), wedge(0.8, 2.3), wedge(3.5, 4.5)})).report.bodies, 1);
}

// A prism that stands with one edge on a band.
Shape with_prism(Shape band, int p, int q, const Vec3& up) {
  const auto at = [&](int v) { return Vec3(band.points[v][0], band.points[v][1], band.points[v][2]); };
  const Vec3 along = at(q) - at(p), aside = glm::cross(along, up);
  const int first = static_cast<int>(band.points.size());
  for (const int v : {p, q})
    for (const double side : {-0.3, 0.3}) {
      const Vec3 corner = at(v) + 0.5 * up + side * aside;
      band.points.push_back({corner.x, corner.y, corner.z});
    }
  for (const std::vector<int>& face : {std::vector{p, first + 1, first},
                                       {q, first + 2, first + 3},
                                       {p, first, first + 2, q},
                                       {q, first + 3, first + 1, p},
                                       {first, first + 1, first + 3, first + 2}})
    band.faces.push_back(face);
  return band;
}

TEST(Bodies, OnAOneSidedSurfaceArePartsOfIt) {
  const Shape band = moebius(12);
  int edges = 0;
  for (std::size_t f = 0; f < band.faces.size(); ++f)
    for (std::size_t i = 0; i < band.faces[f].size(); ++i) {
      const int p = band.faces[f][i], q = band.faces[f][(i + 1) % band.faces[f].size()];
      const auto has = [p, q](const std::vector<int>& face) {
        return std::count(face.begin(), face.end(), p) + std::count(face.begin(), face.end(), q) == 2;
      };
      if (std::count_if(band.faces.begin(), band.faces.end(), has) != 2) continue;
      ++edges;
      const auto at = [&](int v) { return Vec3(band.points[v][0], band.points[v][1], band.points[v][2]); };
      const int other = band.faces[f][(i + 2) % band.faces[f].size()];
      const Vec3 up = glm::normalize(glm::cross(at(q) - at(p), at(other) - at(p)));
      for (const Vec3& side : {up, -up}) EXPECT_EQ(built(with_prism(band, p, q, side)).report.bodies, 1);
    }
  EXPECT_GT(edges, 6);
}

}  // namespace
}  // namespace epura::test::bodies_test
