// SPDX-License-Identifier: Apache-2.0
// Sections: what is left of a part is drawn like a part of that shape; cut faces hide what lies behind them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <utility>

#include "drawing/cut_faces.hpp"
#include "refine/refine_world.hpp"
#include "shapes.hpp"

namespace epura::test::section_test {
namespace {

scene::CuttingPlane plane_at(const Vec3& point, const Vec3& normal) {
  return scene::make_cutting_plane({{"A", "--section"}, point, normal});
}

Result draw_cut(const world::World& world, const scene::CuttingPlane& plane, const projection::Projection& projection,
                const view::ViewLimits& limits = {}) {
  return draw(cut::cut_world(world, plane).world, projection, {}, limits);
}

// A tube of square section along y, closed by a wall at each end.
Shape hollow(double from, double to) {
  Shape shape = box({0, from, 0}, {4, to, 4});
  Shape inside = box({1, from + 1, 1}, {3, to - 1, 3});
  for (auto& face : inside.faces) std::reverse(face.begin(), face.end());
  shape.add(inside);
  return shape;
}

// The same, open at y = from: a cup.
Shape cup(double from, double to) {
  Shape shape = box({0, from, 0}, {4, to, 4});
  shape.add(box({1, from, 1}, {3, to - 1, 3}));
  const auto lies_at = [&](const std::vector<int>& face) {
    return std::all_of(face.begin(), face.end(), [&](int v) { return shape.points[v][1] == from; });
  };
  std::erase_if(shape.faces, lies_at);
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 5), std::pair(5, 4), std::pair(4, 0)})
    shape.faces.push_back({a, b, 8 + b, 8 + a});
  return shape;
}

const std::vector<Vec3> directions = {{1, -1, 1}, {-1, -2, 0.5}, {0.3, -1, -0.7}, {1, 1, 1}, {0, -1, 0}, {0, 0, 1}};

TEST(Section, OfABoxLooksLikeTheShorterBox) {
  const world::World whole = world_of(box({0, 0, 0}, {4, 6, 4})), half = world_of(box({0, 2.5, 0}, {4, 6, 4}));
  for (const Vec3& direction : directions) {
    const Vec3 up = direction.z == 1 && direction.y == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Result cut = draw_cut(whole, plane_at({1, 2.5, 1}, {0, -1, 0}), orthographic(direction, up));
    const Result expected = draw(half, orthographic(direction, up));
    EXPECT_NEAR(cut.visible(), expected.visible(), 1e-8);
    EXPECT_NEAR(cut.hidden_length(), expected.hidden_length(), 1e-8);
  }
}

TEST(Section, OfAHollowBoxLooksLikeACup) {
  const world::World whole = world_of(hollow(-6, 6)), half = world_of(cup(0, 6));
  for (const Vec3& direction : directions) {
    const Vec3 up = direction.z == 1 && direction.y == 0 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Result cut = draw_cut(whole, plane_at({0, 0, 0}, {0, -1, 0}), orthographic(direction, up));
    const Result expected = draw(half, orthographic(direction, up));
    EXPECT_NEAR(cut.visible(), expected.visible(), 1e-8);
    EXPECT_NEAR(cut.hidden_length(), expected.hidden_length(), 1e-8);
  }
  const projection::Projection eye = perspective({2, -12, 9}, {0, 0, 0}, {0, -1, 0.3}, {0, 0, 1});
  const Result cut = draw_cut(whole, plane_at({0, 0, 0}, {0, -1, 0}), eye), expected = draw(half, eye);
  EXPECT_NEAR(cut.visible(), expected.visible(), 1e-7);
  EXPECT_NEAR(cut.hidden_length(), expected.hidden_length(), 1e-7);
}

TEST(Section, CutFacesHideWhatLiesBehind) {
  const world::World world = world_of({box({0, 0, 0}, {4, 4, 4}), box({1, 5, 1}, {3, 6, 3})});
  const Result cut = draw_cut(world, plane_at({0, 2, 0}, {0, -1, 0}), orthographic({0, -1, 0}));
  EXPECT_NEAR(cut.visible(), 16, 1e-8);
  EXPECT_NEAR(cut.hidden_length(), 8, 1e-8);
  for (const drawing::Segment& segment : cut.drawing.segments)
    if (segment.model == 0) {
      EXPECT_TRUE(segment.visible);
    }
}

TEST(Section, WhatIsTakenAwayNeitherHidesNorCrosses) {
  // A wall in front of a box, and a bar that runs through the wall only.
  const world::World world =
      world_of({box({-5, -3, -5}, {5, -2, 5}), box({0, -10, 0}, {1, -1, 1}), box({-1, 0, -1}, {2, 3, 2})});
  const scene::CuttingPlane plane = plane_at({0, 1, 0}, {0, -1, 0});
  const Result cut = draw_cut(world, plane, orthographic({0.1, -1, 0.2}));
  const Result alone = draw_cut(world_of(box({-1, 0, -1}, {2, 3, 2})), plane, orthographic({0.1, -1, 0.2}));
  EXPECT_NEAR(cut.visible(), alone.visible(), 1e-7);
  EXPECT_NEAR(cut.hidden_length(), alone.hidden_length(), 1e-7);
  for (const drawing::Segment& segment : cut.drawing.segments) EXPECT_NE(segment.kind, EdgeKind::intersection);
}

TEST(Section, LinesSayWhereTheyAreInTheFile) {
  const world::World whole = world_of(box({0, 0, 0}, {4, 6, 4}));
  const Result cut = draw_cut(whole, plane_at({1, 2.5, 1}, {0, -1, 0}), orthographic({1, -1, 1}));
  int along_y = 0, outline = 0;
  for (const drawing::Segment& segment : cut.drawing.segments) {
    const auto page = [&](const Vec3& p) { return Vec2(cut.drawing.world_to_page * Vec4(p, 1)); };
    std::array<Vec3, 2> ends;
    if (segment.edge[0] < 0) {
      ++outline;
      EXPECT_EQ(segment.kind, EdgeKind::section);
      const drawing::CrossingSegment& crossing = cut.drawing.crossings.at(segment.crossing);
      EXPECT_EQ(crossing.faces[1][0], -1);
      EXPECT_LT(crossing.faces[0][1], 6);
      ends = crossing.world;
      EXPECT_NEAR(ends[0].y, 2.5, 1e-15);
    } else {
      const Vec3 p = whole.points[segment.edge[0]], q = whole.points[segment.edge[1]];
      ends = {p + segment.t[0] * (q - p), p + segment.t[1] * (q - p)};
      along_y += p.y != q.y ? 1 : 0;
    }
    EXPECT_LT(glm::distance(page(ends[0]), segment.from), 1e-12);
    EXPECT_LT(glm::distance(page(ends[1]), segment.to), 1e-12);
  }
  EXPECT_EQ(outline, 8);  // two triangles of each face
  EXPECT_EQ(along_y, 4);
}

double ring_area(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], b = ring[(i + 1) % ring.size()];
    sum += cross(a, b) / 2;
  }
  return std::abs(sum);
}

TEST(Section, FacesOnPaperAreSeenFromInFrontAndWithinTheWindow) {
  const scene::CuttingPlane plane = plane_at({1, 2.5, 1}, {0, -1, 0});
  const cut::CutWorld cut = cut::cut_world(world_of(box({0, 0, 0}, {4, 6, 4})), plane);
  projection::Projection front = orthographic({0, -1, 0});
  view::ProjectedScene view = view::project_scene(cut.world, front, {});
  const double unit = 1 / (view.map.normalisation * view.map.normalisation);
  const auto faces = drawing::cut_faces_on_paper(cut, plane, cut.world, view, {1, Vec2(0)});
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_NEAR(ring_area(faces[0].rings.at(0)) * unit, 16, 1e-12);
  view::ProjectedScene behind = view::project_scene(cut.world, orthographic({0, 1, 0.5}), {});
  EXPECT_TRUE(drawing::cut_faces_on_paper(cut, plane, cut.world, behind, {1, Vec2(0)}).empty());
  front.window = projection::Window{{1, 1}, {3, 9}};
  view::ProjectedScene part = view::project_scene(cut.world, front, {});
  EXPECT_NEAR(
      ring_area(drawing::cut_faces_on_paper(cut, plane, cut.world, part, {1, Vec2(0)}).at(0).rings.at(0)) * unit, 6,
      1e-12);
}

// Contours on the surfaces of a model are more vertices: those of the next model have other numbers in the view.
TEST(Section, FacesOfSeveralModelsAreThoseOfTheirCuts) {
  const Shape post = frustum(10, 10, 30, 24);
  const world::World world = recognised(world_of({post, post.moved(25, 3, 0), post.moved(50, -3, 0)}));
  const scene::CuttingPlane plane = plane_at({0, 2, 0}, {0, -1, 0});
  const cut::CutWorld cut = cut::cut_world(world, plane);
  const projection::Projection aside = orthographic({0.3, -1, 0.4});
  const auto refined = refine::refine_world(cut.world, aside);
  ASSERT_TRUE(refined);
  ASSERT_GT(refined->first_vertex[1], cut.world.first_vertex[1]);
  view::ProjectedScene whole = view::project_scene(cut.world, aside, {});
  view::ProjectedScene split = view::project_scene(*refined, aside, {});
  const auto expected = drawing::cut_faces_on_paper(cut, plane, cut.world, whole, {1, Vec2(0)});
  const auto faces = drawing::cut_faces_on_paper(cut, plane, *refined, split, {1, Vec2(0)});
  ASSERT_EQ(faces.size(), 3U);
  for (std::size_t i = 0; i < faces.size(); ++i)
    EXPECT_NEAR(ring_area(faces[i].rings.at(0)), ring_area(expected[i].rings.at(0)),
                1e-3 * ring_area(expected[i].rings.at(0)));
}

// --- planes beside vertices

Shape triangulated(const Shape& shape) {
  Shape result{shape.points, {}, {}};
  for (const auto& face : shape.faces)
    for (std::size_t i = 2; i < face.size(); ++i) result.faces.push_back({face[0], face[i - 1], face[i]});
  return result;
}

Shape prism(int sides) {
  Shape shape;
  std::vector<int> bottom, top;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * M_PI * i / sides;
    for (const double z : {0.0, 3.0}) shape.points.push_back({std::cos(a), std::sin(a), z});
    const int j = (i + 1) % sides;
    shape.faces.push_back({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
    bottom.insert(bottom.begin(), 2 * i);
    top.push_back(2 * i + 1);
  }
  shape.faces.push_back(bottom);
  shape.faces.push_back(top);
  return shape;
}

Shape cube_with_a_bore(int sides) {
  Shape shape;
  for (int i = 0; i < sides; ++i) {
    const double a = 2 * M_PI * (i + 0.5) / sides, c = std::cos(a), s = std::sin(a);
    const double out = 1 / std::max(std::abs(c), std::abs(s));  // on the sides of the cube
    for (const double z : {-1.0, 1.0})
      for (const double radius : {0.5, out}) shape.points.push_back({radius * c, radius * s, z});
  }
  for (int i = 0; i < sides; ++i) {
    const int k = 4 * i, l = 4 * ((i + 1) % sides);
    shape.faces.push_back({k, k + 1, l + 1, l});
    shape.faces.push_back({k + 2, l + 2, l + 3, k + 3});
    shape.faces.push_back({k + 1, k + 3, l + 3, l + 1});
    shape.faces.push_back({k, l, l + 2, k + 2});
  }
  return shape;
}

// Faces and corners in another order; coordinates as a file of 32-bit floats has them, or as they are.
world::World numbered_anew(const Shape& shape, unsigned seed, bool floats) {
  std::mt19937 random(seed);
  std::vector<int> number(shape.points.size());
  std::iota(number.begin(), number.end(), 0);
  std::vector<std::vector<int>> faces = shape.faces;
  if (seed != 0) {
    std::shuffle(number.begin(), number.end(), random);
    std::shuffle(faces.begin(), faces.end(), random);
    for (auto& face : faces) std::rotate(face.begin(), face.begin() + random() % face.size(), face.end());
  }
  mesh::Soup soup;
  soup.points = shape.points;
  soup.single_precision = floats;
  for (std::size_t v = 0; v < number.size(); ++v)
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = shape.points[v][i];
      soup.points[number[v]][i] = floats ? static_cast<double>(static_cast<float>(x)) : x;
    }
  for (const auto& face : faces) {
    for (const int v : face) soup.corners.push_back(number[v]);
    soup.end_face();
  }
  return world::make_world({{std::make_shared<const mesh::Mesh>(mesh::build_mesh(std::move(soup), "test"))}});
}

std::vector<Shape> shapes_to_cut() {
  return {triangulated(prism(11)), triangulated(prism(48)), triangulated(uv_sphere(16, 8)),
          triangulated(cube_with_a_bore(16))};
}

// Planes along which no edge runs: what they leave changes steadily with their distance from the vertex.
TEST(Section, BesideAVertexChangesSteadilyAndKnowsNoOrderOfFaces) {
  const std::vector<Vec3> normals = {{0.21, -0.9, 0.37}, {-0.55, -0.62, 0.4}};
  const projection::Projection view = orthographic({1, -1, 1});
  for (const Shape& shape : shapes_to_cut())
    for (const bool floats : {false, true})
      for (const std::size_t vertex : {std::size_t{1}, shape.points.size() / 2})
        for (const Vec3& normal : normals) {
          const world::World world = numbered_anew(shape, 0, floats), other = numbered_anew(shape, 7, floats);
          const Vec3 at = world.points[static_cast<int>(vertex)];
          const Result through = draw_cut(world, plane_at(at, normal), view);
          for (const double distance : {1e-15, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 3e-7, 1e-6, 3e-6, 1e-5})
            for (const double side : {-distance, distance}) {
              const scene::CuttingPlane plane = plane_at(at + side * glm::normalize(normal), normal);
              const Result cut = draw_cut(world, plane, view), again = draw_cut(other, plane, view);
              const double min = 1e-3 * through.extent();
              const auto where = [&] {
                return std::to_string(shape.faces.size()) + " faces, vertex " + std::to_string(vertex) + ", " +
                       (floats ? "floats, " : "doubles, ") + std::to_string(std::log10(distance));
              };
              EXPECT_NEAR(cut.visible(), through.visible(), min) << where();
              EXPECT_NEAR(cut.hidden_length(), through.hidden_length(), min) << where();
              EXPECT_NEAR(again.visible(), cut.visible(), min) << where();
              EXPECT_NEAR(again.hidden_length(), cut.hidden_length(), min) << where();
            }
        }
}

}  // namespace
}  // namespace epura::test::section_test
